"""A stressed element that turns once around keeps its stress, and its forces turn with it."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from vmharness.explicit.elements.shell.belytschko_tsay import Hourglass

X = np.array([[0.0, 0, 0.05], [1.1, 0.1, -0.05], [0.9, 1, 0.05], [-0.1, 0.8, -0.05]])
NODES = np.array([[0, 1, 2, 3]])


def invariants(stress):
    """Trace, J2 and the size of the transverse shear, (nip, 3)."""
    xx, yy, xy, yz, zx = stress.T
    return np.stack([xx + yy, xx**2 - xx * yy + yy**2 + 3 * xy**2, yz**2 + zx**2], axis=1)


@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 0, 0), (0, 1, 0), (1, 2, -2)])
def test_full_turn_in_steps_of_one_degree(bench, axis):
    """Invariants stay within 1e-4. Without the correction for the chord a turn would leave 1.6e-4 of shear strain."""
    block = bench.shells(X, NODES, 0.05, nip=2, hourglass=Hourglass(ihq=4))
    prestress = 1e-3 * bench.E * np.array([[[1.0, -0.4, 0.3, 0.2, -0.1], [0.5, 0.7, -0.6, 0.2, -0.1]]])
    block.stress = prestress
    s = bench.state(X)
    s.dt = 0.0
    f0, moment0 = bench.internal_forces(block, s)
    s.dt = 0.01
    turn = np.radians(1.0) * np.array(axis) / np.linalg.norm(axis)
    for n in range(1, 361):
        R = Rotation.from_rotvec(n * turn).as_matrix()
        s.v[:] = (X @ R.T - s.x) / s.dt
        s.omega[:] = turn / s.dt
        s.x[:] = X @ R.T
        f, moment = bench.internal_forces(block, s)
        if n == 77:
            assert f == pytest.approx(f0 @ R.T, abs=1e-5 * np.abs(f0).max())
            assert moment == pytest.approx(moment0 @ R.T, abs=1e-5 * np.abs(moment0).max())
    before, after = invariants(prestress[0]), invariants(block.stress[0])
    assert after == pytest.approx(before, rel=1e-4)
    assert np.abs(block.stress - prestress).max() < 1e-8 * bench.E
    assert np.abs(block.hourglass).max() < 1e-12 * np.abs(f0).max()
