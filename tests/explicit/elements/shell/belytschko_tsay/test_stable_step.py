"""The step is the formula's; what is truly stable, and that rotations never limit it."""

import numpy as np
import pytest
from scipy.linalg import eigh

from vmharness.explicit.elements.shell.belytschko_tsay import nodal_mass

KITE = np.array(
    [[0.0, 0, 0], [3, 0, 0], [4, 2, 0], [0, 4, 0]]
)  # sides 3, sqrt 5, sqrt 20, 4; diagonals sqrt 20, 5; A = 11


def step(bench, x, isdo, **material):
    block, s = bench.shells(x, np.array([[0, 1, 2, 3]]), 1.0, isdo=isdo, **material), bench.state(x)
    s.dt = 0.0
    block.add(s)
    return block.stable_step()


def test_step_of_a_real_run(bench):
    """LS-DYNA R10.1 prints 1.65463E-03 for 10 x 10 mm, E 210, rho 7.8e-6, nu 0.3, with TSSFAC 0.9."""
    square = np.array([[0.0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]])
    assert f"{0.9 * step(bench, square, 0, e=210.0, nu=0.3, rho=7.8e-6):.5E}" == "1.65463E-03"


@pytest.mark.parametrize(
    ("isdo", "length", "speed"),
    [
        (0, 11 / np.sqrt(20), np.sqrt(3 / (2 * (1 - 0.25**2)))),
        (1, 11 / 5, np.sqrt(3 / (2 * (1 - 0.25**2)))),
        (2, 11 / np.sqrt(20), np.sqrt(3 / 2)),  # more than the shortest side, sqrt 5
    ],
)
def test_formula(bench, isdo, length, speed):
    assert step(bench, KITE, isdo, e=3.0, nu=0.25, rho=2.0) == pytest.approx(length / speed)


def test_isdo_2_takes_the_shortest_side_of_a_sliver(bench):
    sliver = np.array([[0.0, 0, 0], [4, 0, 0], [4.9, 0.1, 0], [0.5, 1, 0]])
    side = np.linalg.norm([0.9, 0.1])
    assert step(bench, sliver, 2, e=3.0, nu=0.25, rho=2.0) == pytest.approx(side / np.sqrt(3 / 2))


def test_step_follows_the_geometry(bench):
    x, nodes = bench.rectangles(3, 1, 3.0, 1.0)
    block, s = bench.shells(x, nodes, 0.1), bench.state(x)
    block.add(s)
    before = block.stable_step()
    s.x[:, 1] *= 0.5
    block.add(s)
    assert block.stable_step() == pytest.approx(before / 2)


def highest(bench, x, nodes, t, nu, shrf, components):
    """2 / omega_max of the free sheet, in units of L / c."""
    block = bench.shells(x, nodes, t, nu=nu, shrf=shrf)
    free = [(i, k) for i in range(len(x)) for k in components]
    K = bench.stiffness(block, x, free)
    mass = bench.lumped(x, nodes, t, nu=nu, shrf=shrf)[tuple(np.transpose(free))]
    scaled = K / np.sqrt(np.outer(mass, mass))
    return 2 / np.sqrt(eigh((scaled + scaled.T) / 2, eigvals_only=True)[-1]) / block.stable_step()


@pytest.mark.parametrize("nu", [0.0, 0.1, 0.3, 0.45])
@pytest.mark.parametrize("t", [0.01, 1.0, 3.0])
@pytest.mark.parametrize("shrf", [5 / 6, 1.0])
@pytest.mark.parametrize("cells", [(1, 1), (4, 1), (3, 3)])
def test_rotations_never_limit_the_step(bench, cells, shrf, t, nu):
    """Bending and shear of a free sheet are stable where its membrane is, or else up to L/c."""
    x, nodes = bench.rectangles(*cells, *map(float, cells))
    alone, _ = bench.rectangles(1, 1, 1.0, 1.0)
    membrane = highest(bench, alone, np.array([[0, 2, 3, 1]]), t, nu, shrf, (0, 1))
    assert membrane == pytest.approx(1 / np.sqrt(1 + nu), rel=1e-6)  # a lone free square: less than L/c
    assert highest(bench, x, nodes, t, nu, shrf, (2, 3, 4)) > membrane * (1 - 1e-9)


def test_mass_and_inertia():
    """rho A t / 4; A/8, or t^2/12 of a thick plate; A/4 at nu = 0 and kappa = 1."""
    x = np.array([[[0.0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]]])
    thick, thin = np.array([3.0]), np.array([0.1])
    assert nodal_mass(x, thin, 5.0, 0.3, 1.0) == (pytest.approx([0.25]), pytest.approx([0.25 * 2 / 8]))
    assert nodal_mass(x, thin, 5.0, 0.0, 1.0)[1] == pytest.approx([0.25 * 2 / 4])
    assert nodal_mass(x, thick, 5.0, 0.3, 1.0)[1] == pytest.approx([7.5 * 9 / 12])
