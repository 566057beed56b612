"""The stable step and the true limit, frequencies, and motion in time."""

import numpy as np
import pytest
from scipy.linalg import eigh

from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

SLENDERNESS = (0.002, 0.02, 0.1, 0.15, 0.16, 0.2, 0.5, 2.0)  # radius of gyration / length of the element


def square(bench, radius):
    """A square section with this radius of gyration."""
    side = radius * np.sqrt(12)
    return bench.section(side**2, side**4 / 12, side**4 / 12, 0.1406 * side**4)


def spectrum(bench, x, nodes, section, held=()):
    K, mass = bench.stiffness_matrix(x, nodes, section, (0.3, 0.1, 1.0)), bench.mass_matrix(x, nodes, section)
    free = np.setdiff1d(np.arange(mass.size), held)
    scaled = K[np.ix_(free, free)] / np.sqrt(np.outer(mass[free], mass[free]))
    return eigh((scaled + scaled.T) / 2)


def limit(bench, x, nodes, section):
    return 2 / np.sqrt(spectrum(bench, x, nodes, section)[0][-1])


def estimate(bench, x, nodes, section):
    return bench.beams(x, nodes, section, (0.3, 0.1, 1.0)).stable_step()


@pytest.mark.parametrize("radius", SLENDERNESS)
def test_step_is_the_formula_of_ls_dyna(bench, radius):
    """The smaller of L/c and 1/2 L / (c sqrt(3 I (3 / (12 I + A L^2) + 1 / (A L^2))))."""
    section, c = square(bench, radius), np.sqrt(bench.E / bench.RHO)
    a, i = section.a, section.iss
    bending = 0.5 / (c * np.sqrt(3 * i * (3 / (12 * i + a) + 1 / a)))
    assert estimate(bench, *bench.line([1.0]), section) == pytest.approx(min(1 / c, bending))


@pytest.mark.parametrize("radius", SLENDERNESS)
def test_step_is_the_true_limit_of_a_free_element_and_a_bound_for_meshes(bench, radius):
    section = square(bench, radius)
    alone = bench.line([1.0])
    assert limit(bench, *alone, section) == pytest.approx(estimate(bench, *alone, section), rel=1e-4)
    mesh = bench.line([1.0, 1.3, 1.0, 2.0])
    assert limit(bench, *mesh, section) > estimate(bench, *mesh, section) * (1 - 1e-4)
    corner = (
        np.array([[0.0, 0, 0], [1.0, 0, 0], [1.0, 1.2, 0], [1.0, 1.2, 1.0]]),
        alone[1][[0]] + [[0], [1], [2]],
    )
    assert limit(bench, *corner, section) > estimate(bench, *corner, section) * (1 - 1e-4)


@pytest.mark.parametrize(("fraction", "stable"), [(0.99, True), (1.01, False)])
@pytest.mark.parametrize("radius", [0.02, 0.5])
def test_the_true_limit_is_sharp(bench, radius, fraction, stable):
    """Three elements in their highest mode, axial or bending, at a step of 2/omega_max times the fraction."""
    x, nodes = bench.line([1.0, 1.2, 0.9])
    section = square(bench, radius)
    values, modes = spectrum(bench, x, nodes, section)
    mass = bench.mass_matrix(x, nodes, section).reshape(-1, 6)
    start = modes[:, -1].reshape(-1, 6) / np.sqrt(mass)
    dt, block, s = (
        fraction * 2 / np.sqrt(values[-1]),
        bench.beams(x, nodes, section, (0.3, 0.1, 1.0)),
        bench.at_rest(x),
    )
    s.dt, v = dt, 1e-9 * start / np.abs(start).max() / dt
    largest = 0.0
    for _ in range(300):
        f = bench.internal(block, s, s.x + dt * v[:, :3], v[:, 3:])
        v = v - dt * f / mass
        largest = max(largest, np.abs(s.x - x).max() + np.abs(dt * v).max())
    assert (largest < 1e-6) == stable


@pytest.mark.parametrize(("n", "modes"), [(20, 1), (40, 2)])
def test_cantilever_frequencies(bench, n, modes):
    """L = 1, b = 0.02, h = 0.01, both planes: the first of 20 elements, two of 40, within 0.3 % of Euler and Bernoulli.

    Lumping takes h^2 w'(L) / 6 at the free end (0.40 % of the second on 20 elements), the rotary inertia the rest.
    """
    width, height = 0.02, 0.01
    section = bench.section(width * height, width**3 * height / 12, width * height**3 / 12, 4.578e-9)
    x, nodes = bench.line([1 / n] * n)
    found = np.sqrt(spectrum(bench, x, nodes, section, held=range(6))[0][: 4 * modes])
    for moment in (section.iss, section.itt):
        wave = np.array([1.875104069, 4.694091133])[:modes]
        theory = wave**2 * np.sqrt(bench.E * moment / (bench.RHO * section.a))
        nearest = found[np.abs(found[:, None] - theory).argmin(axis=0)]
        assert nearest == pytest.approx(theory, rel=3e-3)


def test_simply_supported_frequencies(bench):
    """VM-LSDYNA-SOLVE-032: 28.766 Hz is the manual's target, (pi/L)^2 sqrt(EI / rho A); 10 elements, within 0.3 %."""
    n, length, (a, i) = 10, 80.0, (4.0, 4 / 3)
    section = bench.section(a, i, i, 2 * i)
    x, nodes = bench.line([length / n] * n)
    held = [k for k in range(6 * len(x)) if k % 6 not in (1, 5)] + [1, 6 * n + 1]
    omega = np.sqrt(spectrum(bench, x, nodes, section, held)[0][:2])
    theory = (np.array([1, 2]) * np.pi / length) ** 2 * np.sqrt(bench.E * i / (bench.RHO * a))
    assert omega[0] == pytest.approx(theory[0], rel=3e-3)
    inertia = 1 - 1.5 * (np.array([1, 2]) * np.pi / length) ** 2 * i / a / (
        1 - 12 * i / a / (length / n) ** 2
    )
    assert omega == pytest.approx(theory * inertia, rel=5e-4)  # what the lumped rotary inertia takes


DECK = """*KEYWORD
*CONTROL_TERMINATION
{end}
*CONTROL_TIMESTEP
0.0,{tssfac}
*PART
beam
1,1,1
*SECTION_BEAM
1,2
{section}
*MAT_ELASTIC
1,7850.0,2.1E11,0.3
*ELEMENT_BEAM_ORIENTATION
1,1,1,2
0.0,0.0,1.0
2,1,2,3
0.0,0.0,1.0
3,1,3,4
0.0,0.0,1.0
4,1,4,5
0.0,0.0,1.0
*NODE
1,0.0,0.0,0.0
2,0.25,0.0,0.0
3,0.5,0.0,0.0
4,0.75,0.0,0.0
5,1.0,0.0,0.0
"""
SECTION = "2e-4,6.667e-9,1.6667e-9,4.578e-9"
TUMBLING = """*INITIAL_VELOCITY_NODE
1,0.0,-60.0,8.0,0.0,0.0,100.0
2,0.0,-30.0,0.0,0.0,0.0,100.0
3,0.0,0.0,0.0,80.0,0.0,100.0
4,0.0,30.0,0.0,0.0,0.0,100.0
5,0.0,60.0,9.0,0.0,0.0,100.0
"""


def test_a_tumbling_beam_keeps_momentum_angular_momentum_and_energy(deck):
    """About one turn of a free beam, bent and twisted: both momenta to round-off, energy to a thousandth."""
    model = build(deck(DECK.format(end=0.06, tssfac=0.9, section=SECTION) + TUMBLING))
    s = model.state
    mass, inertia = s.mass[:, None], s.inertia[:, None]

    def angular():  # with x_n and v_{n-1/2}: x_n and x_{n-1} give the same
        return (mass * np.cross(s.x, s.v) + inertia * s.omega).sum(axis=0)

    ratio, internal, bent = probe(model, energy="ratio"), probe(model, energy="internal"), []
    across = []
    linear, turning = (mass * s.v).sum(axis=0), angular()
    for _ in steps(model):
        assert (mass * s.v).sum(axis=0) == pytest.approx(linear, abs=1e-10 * np.abs(mass * s.v).sum())
        assert angular() == pytest.approx(turning, abs=1e-10 * np.abs(turning).max())
        assert ratio() == pytest.approx(1.0, abs=2e-3)
        bent.append(internal())
        across.append(s.x[4, 0] - s.x[0, 0])
    assert min(across) < -0.9  # past half a turn
    assert max(bent) > 5.0  # it does deform


def test_order_in_time_is_two(deck):
    """A free beam let go in its bending mode by velocity: shape and time error fall with the square of the step."""
    text = TUMBLING.replace("100.0", "0.0").replace("80.0", "0.0")

    def last(tssfac):
        model = build(
            deck(
                DECK.format(end=2e-3, tssfac=tssfac, section=SECTION)
                + text.replace("60.0", "6.0").replace("30.0", "3.0")
            )
        )
        read = probe(model, node=3, component="z-displacement")
        path = np.array([(s.t, read()) for s in steps(model)])
        return np.interp(1.9e-3, *path.T), path[-1, 1]

    found = [last(f)[0] for f in (0.4, 0.2, 0.1)]
    assert np.log2(abs((found[0] - found[1]) / (found[1] - found[2]))) == pytest.approx(2.0, abs=0.3)
