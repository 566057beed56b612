"""The step that an element asks for, and the true limit 2 / omega_max of small free meshes."""

import numpy as np
import pytest
from scipy.linalg import eigh

from vmharness.explicit.elements.solid.one_point import Hourglass

CUBE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
NODES = np.arange(8)[None]


def wave_speed(bench, nu=None):
    nu = bench.NU if nu is None else nu
    return np.sqrt(bench.E * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * bench.RHO))


@pytest.mark.parametrize("elform", [1, 2])
def test_length_is_volume_over_largest_side(bench, elform):
    x = CUBE * [0.3, 0.2, 0.5]
    x[4:, 0] += 0.1  # sheared: the volume stays, sides x = const do, sides y = const do, those of z stay
    block = bench.solids(x, NODES, elform)
    block.add(bench.state(x))
    sides = [0.2 * np.hypot(0.5, 0.1), 0.3 * 0.5, 0.3 * 0.2]
    assert block.stable_step() == pytest.approx(0.03 / max(sides) / wave_speed(bench), rel=1e-12)


@pytest.mark.parametrize("elform", [1, 2])
@pytest.mark.parametrize("share", [0.95, 0.75, 1.1])
def test_the_wave_speed_is_that_of_the_initial_density(bench, elform, share):
    """In LS-DYNA the step falls with the length: 0.95 and 0.75 at 5 % and 25 % uniaxial compression."""
    block = bench.solids(CUBE, NODES, elform)
    block.add(bench.state(CUBE))
    start = block.stable_step()
    block.add(bench.state(CUBE * [1.0, 1.0, share]))
    assert block.stable_step() / start == pytest.approx(min(share, 1.0), rel=1e-12)
    assert block.steps(CUBE * [1.0, 1.0, share])[0] == pytest.approx(block.stable_step(), rel=1e-12)


@pytest.mark.parametrize("sign", [-1, 1])
def test_bulk_viscosity_shortens_the_step_in_compression(bench, sign):
    """L_e / (Q + sqrt(Q^2 + c^2)), Q = Q2 c + Q1 L_e |D| in compression only."""
    block, s = bench.solids(CUBE, NODES, viscous=(1.5, 0.06)), bench.state(CUBE, dt=0.0)
    s.v[:] = sign * 100.0 * CUBE
    block.add(s)
    c = wave_speed(bench)
    Q = 0.06 * c + 1.5 * 300.0 if sign < 0 else 0.0
    assert block.stable_step() == pytest.approx(1 / (Q + np.hypot(Q, c)), rel=1e-12)


def true_limit(bench, x, nodes, elform, control, nu):
    """2 / omega_max of the free mesh, in units of the shortest L_e / c."""
    block = bench.solids(x, nodes, elform, control, nu=nu)
    used = np.unique(nodes)
    free = [(i, k) for i in used for k in range(3)]
    K = bench.stiffness(block, x, free)
    root = np.sqrt(bench.lumped(x, nodes)[[i for i, _ in free], 0])
    scaled = K / np.outer(root, root)
    block.add(bench.state(x))
    return 2 / np.sqrt(eigh((scaled + scaled.T) / 2, eigvals_only=True)[-1]) / block.stable_step()


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize(("elform", "control"), [(1, Hourglass(ihq=4)), (1, Hourglass(ihq=2)), (2, None)])
def test_a_lone_free_cube_reaches_less_than_the_estimate(bench, elform, control, nu):
    """sqrt((1 - nu) / (1 + nu)) L/c by the mode that stretches it in all directions: 0.73 at nu = 0.3."""
    limit = true_limit(bench, CUBE, NODES, elform, control, nu)
    assert limit == pytest.approx(np.sqrt((1 - nu) / (1 + nu)), rel=1e-6)


@pytest.mark.parametrize(("cells", "limit"), [((8, 1, 1), 0.81), ((2, 2, 2), 0.936), ((3, 3, 3), 0.93)])
@pytest.mark.parametrize(("elform", "control"), [(1, Hourglass(ihq=4)), (1, Hourglass(ihq=2)), (2, None)])
def test_a_free_mesh_reaches_less_than_the_estimate_too(bench, elform, control, cells, limit):
    """A bar of cubes, one across, is not safe at TSSFAC = 0.9 without bulk viscosity; meshes of several across are."""
    x, nodes = bench.boxes(*cells, *map(float, cells))
    assert true_limit(bench, x, nodes, elform, control, 0.3) == pytest.approx(limit, abs=0.003)


@pytest.mark.parametrize(("elform", "control"), [(1, Hourglass(ihq=4)), (2, None)])
def test_a_lone_wedge_exceeds_the_estimate(bench, elform, control):
    x = CUBE.copy()
    x[[4, 6]] = [0, 0, 1], [0, 1, 1]
    limit = true_limit(bench, x, np.array([[0, 1, 2, 3, 4, 4, 6, 6]]), elform, control, 0.3)
    assert limit == pytest.approx(1.564, abs=0.001)


@pytest.mark.parametrize("elform", [1, 2])
def test_stable_just_below_the_true_limit_and_unstable_just_above(bench, elform):
    """A lone cube stretched by 1e-9 of itself, 600 steps at 0.99 and 1.01 of 2 / omega_max."""
    control = Hourglass(ihq=4)
    limit = np.sqrt(0.7 / 1.3) / wave_speed(bench)
    for factor, stable in ((0.99, True), (1.01, False)):
        block, s, mass = (
            bench.solids(CUBE, NODES, elform, control),
            bench.state(CUBE),
            bench.lumped(CUBE, NODES),
        )
        s.v[:] = 1e-6 * (CUBE - 0.5) + 1e-9 * np.random.default_rng(1).normal(size=CUBE.shape)
        s.dt = dt = factor * limit
        start = np.abs(s.v).max()
        for _ in range(600):
            s.x += dt * s.v
            s.v -= dt * bench.internal_forces(block, s) / mass
            if np.abs(s.v).max() > 1e3 * start:
                break
        assert bool(np.abs(s.v).max() < 20 * start) is stable
