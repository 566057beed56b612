"""Rigid motion strains nothing; a linear field strains just as it should, in any shape; turning keeps stress."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from vmharness.explicit.elements.solid.one_point import Hourglass

CUBE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
NODES = np.arange(8)[None]
WEDGE = np.array([[0, 1, 2, 3, 4, 4, 7, 7]])
STIFF = Hourglass(ihq=4)
KINDS = [(1, STIFF), (1, Hourglass(ihq=2)), (2, None)]


def distorted(seed=1):
    return CUBE + 0.25 * np.random.default_rng(seed).uniform(-1, 1, (8, 3))


def hooke(bench, strain):
    G, lam = bench.E / (2 * (1 + bench.NU)), bench.E * bench.NU / ((1 + bench.NU) * (1 - 2 * bench.NU))
    s = lam * np.trace(strain) * np.eye(3) + 2 * G * strain
    return np.array([s[0, 0], s[1, 1], s[2, 2], s[0, 1], s[1, 2], s[2, 0]])


@pytest.mark.parametrize(("elform", "control"), KINDS)
@pytest.mark.parametrize("nodes", [NODES, WEDGE])
def test_rigid_velocity_strains_nothing(bench, elform, control, nodes):
    x, w = distorted(), np.array([0.3, -0.5, 0.7])
    block = bench.solids(x, nodes, elform, control, viscous=(1.5, 0.06))
    s = bench.state(x, dt=1.0)
    s.v[:] = np.array([1.0, 2.0, 3.0]) + np.cross(w, x)
    s.x += 0.5 * s.v  # the mid-step geometry is x
    assert np.abs(bench.internal_forces(block, s)).max() < 1e-14 * bench.E
    assert np.abs(block.stress).max() < 1e-14 * bench.E
    assert abs(block.energy["internal"][0]) < 1e-24 * bench.E


@pytest.mark.parametrize(("elform", "control"), KINDS)
@pytest.mark.parametrize("nodes", [NODES, WEDGE])
def test_uniform_strain_is_exact(bench, elform, control, nodes):
    """Stress and forces of a linear field: s = C : e, and f_I = V s . B_I, which is what a pressure of that stress does."""
    x, A = distorted(), 1e-9 * np.random.default_rng(2).normal(size=(3, 3))
    block, s = bench.solids(x, nodes, elform, control), bench.state(x)
    s.v[:] = x @ A.T
    s.x += 0.5 * s.v
    f = bench.internal_forces(block, s)
    sigma = hooke(bench, (A + A.T) / 2)
    assert block.stress == pytest.approx(np.broadcast_to(sigma, block.stress.shape), rel=1e-8)
    assert block.energy["hourglass"][0] < 1e-20 * block.energy["internal"][0]
    full = sigma[[0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(3, 3)
    virial = f.T @ s.x  # sum f (x) x = V s
    volume = block._fixed[0, 0] / bench.RHO
    assert virial == pytest.approx(volume * full, rel=1e-7, abs=1e-7 * np.abs(full).max())


@pytest.mark.parametrize(("elform", "control"), KINDS)
def test_macneal_harder_solid_patch(bench, elform, control):
    """Seven distorted solids in a cube under u = 1e-3 (2x+y+z, x+2y+z, x+y+2z)/2: s_xx = 2000, s_xy = 400 at E = 1e6."""
    inner = np.array([
        [0.249, 0.342, 0.192], [0.826, 0.288, 0.288], [0.850, 0.649, 0.263], [0.273, 0.750, 0.230],
        [0.320, 0.186, 0.643], [0.677, 0.305, 0.683], [0.788, 0.693, 0.644], [0.165, 0.745, 0.702],
    ])  # fmt: skip
    x = np.vstack([inner, CUBE])
    i, o = np.arange(8), np.arange(8, 16)
    sides = [(0, 1, 2, 3), (1, 0, 4, 5), (2, 1, 5, 6), (3, 2, 6, 7), (0, 3, 7, 4), (5, 4, 7, 6)]
    nodes = np.array([i, *([*o[list(side)], *i[list(side)]] for side in sides)])
    E, nu = 1e6, 0.25
    block, s = bench.solids(x, nodes, elform, control, e=E, nu=nu), bench.state(x)
    s.v[:] = 1e-12 * x @ (0.5 * (np.ones((3, 3)) + np.eye(3)))
    s.x += 0.5 * s.v
    f = bench.internal_forces(block, s)
    exact = 1e-9 * np.array([2000, 2000, 2000, 400, 400, 400])
    assert block.stress == pytest.approx(np.broadcast_to(exact, block.stress.shape), rel=1e-10)
    assert np.abs(f[:8]).max() < 1e-12 * np.abs(f).max()  # inner nodes are in equilibrium


@pytest.mark.parametrize(("elform", "control"), [(1, STIFF), (2, None)])
@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 2, -2)])
def test_full_turn_in_steps_of_one_degree(bench, elform, control, axis):
    """A stressed solid turned once around has its stress again, and forces turn with it: to round-off."""
    x = distorted()
    block, s = bench.solids(x, NODES, elform, control), bench.state(x, dt=0.01)
    s.v[:] = 0.1 * np.random.default_rng(3).normal(size=x.shape)
    s.x += s.dt * s.v
    f0 = bench.internal_forces(block, s)
    before, start = block.stress, s.x.copy()
    turn = np.radians(1.0) * np.array(axis) / np.linalg.norm(axis)
    for n in range(1, 361):
        R = Rotation.from_rotvec(n * turn).as_matrix()
        s.v[:] = (start @ R.T - s.x) / s.dt
        s.x[:] = start @ R.T
        f = bench.internal_forces(block, s)
        if n == 77:
            assert f == pytest.approx(f0 @ R.T, abs=1e-10 * np.abs(f0).max())
    assert block.stress == pytest.approx(before, abs=1e-10 * np.abs(before).max())
    assert f == pytest.approx(f0, abs=1e-10 * np.abs(f0).max())


@pytest.mark.parametrize("elform", [1, 2])
@pytest.mark.parametrize("plane", [(0, 1), (1, 2), (2, 0)])
def test_simple_shear_follows_the_jaumann_rate(bench, elform, plane):
    """v_i = gamma' x_j to gamma = 4: s_ij = G sin gamma, s_ii = -s_jj = G (1 - cos gamma); the error falls with dt^2."""
    i, j = plane
    G, errors = bench.E / (2 * (1 + bench.NU)), []
    shear = {(0, 1): 3, (1, 2): 4, (2, 0): 5}[plane]
    for steps in (200, 400):
        block, s = bench.solids(CUBE, NODES, elform), bench.state(CUBE, dt=4 / steps)
        worst = 0.0
        for n in range(1, steps + 1):
            s.v[:, i] = CUBE[:, j]
            s.x += s.dt * s.v
            bench.internal_forces(block, s)
            gamma, exact = n * s.dt, np.zeros(6)
            exact[[i, j, shear]] = 1 - np.cos(gamma), np.cos(gamma) - 1, np.sin(gamma)
            worst = max(worst, np.abs(block.stress / G - exact).max())
        errors.append(worst)
    assert errors[0] < 5e-4
    assert errors[1] == pytest.approx(errors[0] / 4, rel=0.05)
