"""The truss: rigid motions, finite stretch, balance, its true step, waves, a pendulum on a stiff bar."""

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.special import ellipk

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.elements.beam.truss import Truss
from vmharness.explicit.loop import steps
from vmharness.explicit.materials.elastic import Elastic, uniaxial
from vmharness.explicit.probes import probe
from vmharness.explicit.state import State

E, RHO, AREA = 2.0e11, 8000.0, 1e-4
C = np.sqrt(E / RHO)


def at_rest(x):
    n = len(x)
    return State(np.array(x, float), np.zeros((n, 3)), np.zeros((n, 3)), np.ones(n), np.ones(n), dt=1.0)


def trusses(x, nodes):
    nodes = np.array(nodes)
    length = np.linalg.norm(x[nodes[:, 1]] - x[nodes[:, 0]], axis=1)
    return Truss("trusses", nodes, length, AREA, RHO, E, uniaxial, Elastic(E, 0.3))


def drive(block, s, path):
    """Go through the positions of `path`, with the mean velocity of each step; the forces at the last."""
    for x in path:
        s.v[:] = (x - s.x) / s.dt
        s.x[:] = x
        s.f[:] = 0.0
        block.add(s)
    return s.f


def chain(lengths):
    """A straight free chain of bars along x."""
    x = np.column_stack([np.concatenate([[0.0], np.cumsum(lengths)]), *np.zeros((2, len(lengths) + 1))])
    return x, np.column_stack([np.arange(len(lengths)), np.arange(1, len(lengths) + 1)])


def spectrum(lengths, fixed=()):
    """omega^2 of axial motion by unit displacements of the element, with its lumped mass; the modes."""
    x, nodes = chain(lengths)
    free = [i for i in range(len(x)) if i not in fixed]
    mass = np.zeros(len(x))
    for end in nodes.T:
        np.add.at(mass, end, 0.5 * RHO * AREA * np.array(lengths))
    K = np.zeros((len(free), len(free)))
    for column, i in enumerate(free):
        moved = x.copy()
        moved[i, 0] += 1e-7
        K[:, column] = -drive(trusses(x, nodes), at_rest(x), [moved])[free, 0] / 1e-7
    values, modes = eigh((K + K.T) / 2, np.diag(mass[free]))
    return values, modes, mass[free]


def rotation(angle, axis):
    k = np.array(axis) / np.linalg.norm(axis)
    K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def test_a_rigid_motion_through_a_full_turn_gives_no_stress():
    """36 steps of 10 degrees about a skew axis while it flies: not one of them strains."""
    x = np.array([[0.3, 0.1, -0.2], [1.1, 0.9, 0.4]])
    block, s = trusses(x, [[0, 1]]), at_rest(x)
    read = block.probe(0, 1, "axial-stress")
    for k in range(1, 37):
        drive(block, s, [x @ rotation(2 * np.pi * k / 36, (1, 2, -1)).T + 0.3 * k])
        assert abs(read()) < 1e-13 * E
    assert abs(block.energy["internal"][0]) < 1e-13 * E * AREA


def turn_and_stretch(n):
    """Stress and energy after a stretch to 1.3 times the length while turning by 120 degrees, in n steps."""
    x = np.array([[0.0, 0, 0], [2.0, 0, 0]])
    block, s = trusses(x, [[0, 1]]), at_rest(x)
    drive(block, s, [(1 + 0.3 * a) * x @ rotation(2 * a, (0, 1, 1)).T for a in np.linspace(0, 1, n + 1)[1:]])
    return block.probe(0, 1, "axial-stress")(), block.energy["internal"][0]


def test_stress_and_energy_of_a_finite_stretch_are_of_second_order():
    """s = E ln(L/L0), energy = E A (L ln(L/L0) - L + L0): errors of the mid-point rule, however it turns."""
    stress, energy = E * np.log(1.3), E * AREA * (2.6 * np.log(1.3) - 0.6)
    errors = np.array([np.array(turn_and_stretch(n)) / (stress, energy) - 1 for n in (10, 20, 40)])
    assert np.all(np.abs(errors[-1]) < 1e-4)
    assert np.log2(errors[:-1] / errors[1:]) == pytest.approx(2.0, abs=0.02)


def test_force_is_minus_the_gradient_of_the_energy():
    """At 20 % stretch, from the energies of neighbouring positions, each reached in 400 steps."""
    x = np.array([[0.1, 0.2, 0.3], [0.9, 0.7, 0.1]])
    end = x + np.array([[0.0, 0.05, 0.0], [0.2, 0.0, 0.1]])

    def reach(target):
        block, s = trusses(x, [[0, 1]]), at_rest(x)
        f = drive(block, s, [x + a * (target - x) for a in np.linspace(0, 1, 401)[1:]])
        return block.energy["internal"][0], f

    _, f = reach(end)
    assert np.abs(f).max() > 0.05 * E * AREA
    for place in np.ndindex(end.shape):
        d = np.zeros_like(end)
        d[place] = 1e-4
        slope = (reach(end + d)[0] - reach(end - d)[0]) / 2e-4
        assert f[place] == pytest.approx(-slope, rel=1e-5, abs=1e-6 * E * AREA)
    assert f.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9 * E * AREA)
    assert np.cross(end, f).sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9 * E * AREA)


def test_many_trusses_are_as_many_as_one():
    """37 bars fill two blocks and a part of a third; each gets what it gets alone."""
    rng = np.random.default_rng(1)
    x = rng.random((40, 3))
    nodes = np.array([rng.choice(40, 2, replace=False) for _ in range(37)])
    moved = x + 1e-2 * rng.random((40, 3))
    together, alone = trusses(x, nodes), [trusses(x, nodes[[e]]) for e in range(37)]
    f = drive(together, at_rest(x), [moved])
    assert f == pytest.approx(sum(drive(one, at_rest(x), [moved]) for one in alone), rel=1e-12)
    assert together.energy["internal"][0] == pytest.approx(sum(one.energy["internal"][0] for one in alone))
    assert together.stable_step() == min(one.stable_step() for one in alone)
    assert together.probe(36, 1, "axial-force")() == AREA * alone[36].probe(0, 1, "axial-stress")()


def test_step_is_the_true_limit_of_a_free_bar_and_a_bound_for_a_chain():
    x, nodes = chain([0.5])
    block = trusses(x, nodes)
    drive(block, at_rest(x), [x])
    assert block.stable_step() == pytest.approx(0.5 / C)
    assert 2 / np.sqrt(spectrum([0.5])[0][-1]) == pytest.approx(0.5 / C, rel=1e-6)
    lengths = [1.0, 0.5, 0.6, 0.7, 0.5, 1.0]
    assert 0.5 / C <= 2 / np.sqrt(spectrum(lengths)[0][-1]) < 0.7 / C


def test_step_of_a_stretched_bar():
    """omega^2 = 4 E / (rho L L0) at L = 2 L0, from the slope of the force: L/c would be too long by sqrt 2."""
    x, nodes = chain([1.0])
    block, s = trusses(x, nodes), at_rest(x)
    path = [np.array([[0.0, 0, 0], [a, 0, 0]]) for a in np.linspace(1, 2, 401)[1:]]
    drive(block, s, path)
    further = drive(block, s, [path[-1] + [[0.0, 0, 0], [1e-6, 0, 0]]])[0, 0]
    before = drive(block, s, [path[-1]])[0, 0]
    omega = np.sqrt((further - before) / 1e-6 * 2 / (0.5 * RHO * AREA))
    assert block.stable_step() == pytest.approx(2 / omega, rel=1e-5)
    assert block.stable_step() == pytest.approx(np.sqrt(2.0) / C)


@pytest.mark.parametrize(("fraction", "stable"), [(0.99, True), (1.01, False)])
def test_the_true_limit_is_sharp(fraction, stable):
    """A chain of unequal bars, started in its highest mode, at a step of 2/omega_max times the fraction."""
    lengths = [1.0, 0.5, 0.6, 0.7]
    values, modes, mass = spectrum(lengths)
    x, nodes = chain(lengths)
    block, s = trusses(x, nodes), at_rest(x)
    start = 1e-9 * modes[:, -1] / np.abs(modes[:, -1]).max()
    s.dt, v = fraction * 2 / np.sqrt(values[-1]), np.zeros_like(x)
    s.x[:, 0] += start
    s.v[:, 0] = start / s.dt
    largest = 0.0
    for _ in range(300):
        s.f[:] = 0.0
        block.add(s)
        v += s.dt * s.f / mass[:, None]
        s.v[:] = v
        s.x += s.dt * v
        largest = max(largest, np.abs(s.x - x).max())
    assert (largest < 1e-6) == stable


def test_frequencies_of_a_fixed_free_bar():
    """Exactly those of the lumped chain, 2c/h sin(k h/2); the first two of 20 elements within 0.3 % of c k."""
    n = 20
    values, _, _ = spectrum([1 / n] * n, fixed=(0,))
    k = (np.arange(n) + 0.5) * np.pi
    assert np.sqrt(values) == pytest.approx(2 * C * n * np.sin(k / (2 * n)), rel=2e-5)
    assert np.sqrt(values[:2]) == pytest.approx(C * k[:2], rel=3e-3)


BAR = """*KEYWORD
*CONTROL_TERMINATION
{end}
*CONTROL_TIMESTEP
0.0,{tssfac}
*PART
bar
1,1,1
*SECTION_BEAM
1,3
{area}
*MAT_ELASTIC
1,{rho},{e},0.3
"""


def test_order_in_time_is_two(deck):
    """A half of a free bar between two masses is a spring: u = u0 cos(omega t), to the second order in dt."""

    def error(tssfac):
        text = BAR.format(end=20.0, tssfac=tssfac, area=1.0, rho=2.0, e=1.0)
        text += "*NODE\n1,0.0,0.0,0.0,7\n2,1.0,0.0,0.0,5\n*ELEMENT_BEAM\n1,1,1,2\n"
        text += "*INITIAL_VELOCITY_NODE\n2,1e-8\n"
        model = build(deck(text))  # k = 1, m = 1
        u = probe(model, node=2, component="x-displacement")
        return np.abs([u() - 1e-8 * np.sin(s.t) for s in steps(model)]).max()

    assert np.log2(error(0.1) / error(0.05)) == pytest.approx(2.0, abs=0.05)
    assert error(0.05) < 1e-8 * 0.05


def test_pendulum_on_a_stiff_bar(deck):
    """Released at 90 degrees: T = 4 sqrt(L/g) K(1/2), tension 3 m g at the bottom; the bar keeps its length."""
    m, g, length, ea = 1.0, 9.81, 1.0, 3e7
    period = 4 * np.sqrt(length / g) * ellipk(0.5)
    text = BAR.format(end=period, tssfac=0.9, area=1.0, rho=2 * m, e=ea)
    text += "*NODE\n1,0.0,0.0,0.0,7\n2,1.0,0.0,0.0\n*ELEMENT_BEAM\n1,1,1,2\n"
    text += "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_BODY_Z\n1,9.81\n"
    model = build(deck(text))
    x, z, t = [], [], []
    force, tension = probe(model, beam=1, component="axial-force"), []
    ratio = probe(model, energy="ratio")
    for s in steps(model):
        x.append(s.x[1, 0]), z.append(s.x[1, 2]), t.append(s.t), tension.append(force())
        if s.t > 0.01 * period:
            assert abs(ratio() - 1) < 2e-4
    lowest = np.interp(0.0, -np.array(x)[: len(x) // 2], t[: len(x) // 2])  # the first passage
    assert lowest == pytest.approx(period / 4, rel=2e-5)
    assert x[-1] == pytest.approx(length, abs=1e-5)
    assert np.hypot(x, z) == pytest.approx(length, abs=5e-6)
    assert np.max(tension) == pytest.approx(3 * m * g, rel=0.01)  # the bar hums a little


@pytest.mark.parametrize(
    ("section", "element", "message"),
    [
        ("1\n1.0", "1,1,1,2", "ELFORM = .*only 2 and 3 are supported"),
        ("1,1\n1.0", "1,1,1,2", "ELFORM = 1: only 2 and 3 are supported"),
        ("1,3\n1.0,0.5", "1,1,1,2", "RAMPT = 0.5: only 0.0 is supported"),
        ("1,3\n1.0,0.0,7.0", "1,1,1,2", "STRESS = 7.0: only 0.0 is supported"),
        ("1,3\n0.0", "1,1,1,2", "A = 0.0: must be greater than 0"),
        ("1,3\n1.0", "1,1,1,2,0,1", "RT1 = 1: only 0 is supported"),
        ("1,3\n1.0", "1,1,1,1", "N2 = 1: lies where the first node is"),
        ("1,3\n1.0", "1,1,1,9", "N2 = 9: no .NODE 9"),
    ],
)
def test_refused(deck, section, element, message):
    text = BAR.format(end=1.0, tssfac=0.9, area=1.0, rho=1.0, e=1.0).replace("1,3\n1.0", section)
    text += f"*NODE\n1,0.0,0.0,0.0,7\n2,1.0,0.0,0.0\n*ELEMENT_BEAM\n{element}\n"
    with pytest.raises(DeckError, match=message):
        build(deck(text))
