"""First frequencies against theory: the stiffness by unit velocities, with the element's own lumped mass."""

import numpy as np
import pytest
from scipy.linalg import eigh

from vmharness.explicit.elements.shell.belytschko_tsay import Hourglass

BENDING = (2, 3, 4)  # w, omega_x, omega_y


def first_frequency(bench, x, nodes, t, nu, free, **options):
    block = bench.shells(x, nodes, t, nu=nu, **options)
    K = bench.stiffness(block, x, free)
    mass = bench.lumped(x, nodes, t, nu=nu, shrf=options.get("shrf", 1.0))[tuple(np.transpose(free))]
    assert np.abs(K - K.T).max() < 1e-10 * np.abs(K).max()
    scaled = K / np.sqrt(np.outer(mass, mass))
    return np.sqrt(eigh((scaled + scaled.T) / 2, eigvals_only=True, subset_by_index=[0, 0])[0])


@pytest.mark.parametrize(
    ("control", "shrf"),
    [(Hourglass(ihq=2), 1.0), (Hourglass(ihq=4, qb=0.05, qw=0.05), 1.0), (Hourglass(ihq=4), 5 / 6)],
)
def test_simply_supported_square_plate(bench, control, shrf):
    """omega = 2 (pi/a)^2 sqrt(D / (rho t)), 20 x 20 elements: within 1 %."""
    t, n = 0.01, 20
    x, nodes = bench.rectangles(n, n, 1.0, 1.0)

    def held(i, k):  # on an edge: w, and the rotation about the normal of the edge
        on_x, on_y = x[i, 0] in (0, 1), x[i, 1] in (0, 1)
        return (k == 2 and (on_x or on_y)) or (k == 3 and on_x) or (k == 4 and on_y)

    free = [(i, k) for i in range(len(x)) for k in BENDING if not held(i, k)]
    omega = first_frequency(bench, x, nodes, t, bench.NU, free, nip=3, shrf=shrf, hourglass=control)
    theory = 2 * np.pi**2 * np.sqrt(bench.E * t**2 / (12 * (1 - bench.NU**2) * bench.RHO))
    assert omega == pytest.approx(theory, rel=0.01)


@pytest.mark.parametrize(("control", "nu"), [(Hourglass(ihq=2), 0.0), (Hourglass(ihq=4), 0.0)])
def test_cantilever(bench, control, nu):
    """omega = (1.875104 / L)^2 sqrt(E t^2 / (12 rho)), 20 x 2 elements: within 1 %."""
    t, length = 0.01, 1.0
    x, nodes = bench.rectangles(20, 2, length, 0.1)
    free = [(i, k) for i in range(len(x)) for k in BENDING if x[i, 0] > 0]
    omega = first_frequency(bench, x, nodes, t, nu, free, nip=3, hourglass=control)
    theory = (1.8751040687 / length) ** 2 * np.sqrt(bench.E * t**2 / (12 * bench.RHO))
    assert omega == pytest.approx(theory, rel=0.01)
