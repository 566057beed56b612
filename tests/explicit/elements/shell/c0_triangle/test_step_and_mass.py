"""The step is the formula's; what is truly stable, that rotations never limit it, and that energy is kept."""

import numpy as np
import pytest

from vmharness.explicit.elements.shell.c0_triangle import nodal_mass

RIGHT = np.array([[0.0, 0, 0], [4, 0, 0], [0, 3, 0]])  # sides 4, 5, 3; A = 6
SHAPES = {
    "equilateral": [[0.0, 0, 0], [1, 0, 0], [0.5, 0.75**0.5, 0]],
    "right": [[0.0, 0, 0], [1, 0, 0], [0, 1, 0]],
    "sliver": [[0.0, 0, 0], [1, 0, 0], [0.3, 0.1, 0]],
    "needle": [[0.0, 0, 0], [1, 0, 0], [0.9, 4, 0]],
}
ALONE = np.array([[0, 1, 2]])


@pytest.mark.parametrize(
    ("isdo", "length", "speed"),
    [
        (0, 12 / 5, np.sqrt(3 / (2 * (1 - 0.25**2)))),
        (1, 12 / 5, np.sqrt(3 / (2 * (1 - 0.25**2)))),
        (2, 3, np.sqrt(3 / 2)),  # the shortest side
    ],
)
@pytest.mark.parametrize("nodes", [[0, 1, 2], [1, 2, 0], [2, 0, 1]])
def test_formula(bench, isdo, length, speed, nodes):
    block, s = (
        bench.shells(RIGHT, np.array([nodes]), 1.0, e=3.0, nu=0.25, rho=2.0, isdo=isdo),
        bench.state(RIGHT),
    )
    block.add(s)
    assert block.stable_step() == pytest.approx(length / speed)
    assert block.steps(RIGHT) == pytest.approx([length / speed])
    block.scale_density(np.array([4.0]))
    block.add(s)
    assert block.stable_step() == pytest.approx(2 * length / speed)


def true_limit(bench, x, nodes, t, components, **material):
    """2 / omega_max of the free elements, in units of L_s / c."""
    free = [(i, k) for i in range(len(x)) for k in components]
    omega = bench.frequencies(x, nodes, t, free, **material)
    return 2 / omega[-1] / bench.shells(x, nodes, t, **material).steps(x).min()


@pytest.mark.parametrize("nu", [0.0, 0.1, 0.3, 0.45])
@pytest.mark.parametrize("t", [0.01, 1.0, 3.0])
@pytest.mark.parametrize("shape", SHAPES)
def test_rotations_never_limit_the_step(bench, shape, t, nu):
    """Bending and shear of a free element are stable where its membrane is: within 0.78 to 0.94 L_s / c."""
    x = np.array(SHAPES[shape])
    membrane = true_limit(bench, x, ALONE, t, (0, 1), nu=nu)
    assert 0.78 < membrane < 0.944
    assert true_limit(bench, x, ALONE, t, (2, 3, 4), nu=nu) > membrane
    if shape == "equilateral":  # the mode that stretches it in all directions: omega^2 = 9/2 (1 + nu) (c/h)^2
        assert membrane == pytest.approx(2 / np.sqrt(4.5 * (1 + nu)), rel=1e-6)


@pytest.mark.parametrize(("cells", "limit"), [((1, 1), 0.94), ((3, 3), 0.97)])
def test_a_free_sheet_is_stable_beyond_the_usual_factor(bench, cells, limit):
    x, nodes = bench.sheet(*cells, 1.0, 1.0)
    assert true_limit(bench, x, nodes, 0.05, range(5)) > limit


def test_mass_and_inertia():
    """rho A t / 3; t^2/12 + 2/9 L^2 s / (2 (1 + |nu|) - s) with s = kappa (1 - nu) = 0.7."""
    mass, inertia = nodal_mass(RIGHT[None], np.array([0.6]), 5.0, 0.3, 1.0)
    assert mass == pytest.approx([6.0])
    assert inertia == pytest.approx([6.0 * (0.03 + 2 / 9 * 25 * 0.7 / 1.9)])


def test_vibrating_spinning_sheet_keeps_its_energy(bench):
    """Bending and stretching over a tumbling motion; the error falls with dt^2."""
    errors = []
    for fraction in (0.8, 0.4):
        x, nodes = bench.sheet(6, 6, 1.0, 1.0)
        block, s, mass = bench.shells(x, nodes, 0.02), bench.state(x), bench.lumped(x, nodes, 0.02)
        w = np.array([20.0, -10.0, 30.0])
        s.v[:], s.omega[:] = np.cross(w, x), w
        s.v[:, 2] += 20 * np.cos(np.pi * x[:, 0])
        s.omega[:, 1] += 20 * np.pi * np.sin(np.pi * x[:, 0])
        s.v[:, 0] += 10 * np.cos(np.pi * x[:, 1])
        u, dt, total = np.hstack([s.v, s.omega]), fraction * block.steps(x).min(), []
        start, s.dt = 0.5 * np.sum(mass * u**2), 0.0
        for n in range(round(400 / fraction)):
            half, force = u, -np.hstack(bench.internal_forces(block, s))
            u = u + (dt if n else dt / 2) * force / mass
            if n:
                total.append(0.5 * np.sum(mass * ((half + u) / 2) ** 2) + block.energy["internal"][0])
            s.v[:], s.omega[:], s.dt = u[:, :3], u[:, 3:], dt
            s.x += dt * s.v
        errors.append(np.abs(np.array(total) / start - 1).max())
        assert block.energy["internal"][0] > 0
        assert block.energy["hourglass"][0] == 0
    assert errors[0] < 1e-3
    assert errors[1] < errors[0] / 3
