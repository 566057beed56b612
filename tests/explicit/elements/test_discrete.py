"""Springs and dampers against exact solutions of the difference equations and of the differential ones."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.build import build
from vmharness.explicit.elements.discrete.limit import stable_step
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe

HEAD = (
    "*KEYWORD\n*CONTROL_TERMINATION\n{end}\n*CONTROL_TIMESTEP\n0.0,{tssfac}\n*SECTION_DISCRETE\n1\n\n2,1\n\n"
)
# A held node 1 at the origin, and a mass on node 2 at x = 2.
MASS = "*NODE\n1,0,0,0,7,7\n2,2.0,0,0\n*ELEMENT_MASS\n1,2,0.5\n"
SPRING = "*PART\nspring\n1,1,1\n*MAT_SPRING_ELASTIC\n1,{k}\n"
DAMPER = "*PART\ndamper\n2,1,2\n*MAT_DAMPER_VISCOUS\n2,{c}\n"


@pytest.fixture
def model(deck):
    def of(keywords, end=1.0, tssfac=0.1):
        return build(deck(HEAD.format(end=end, tssfac=tssfac) + keywords))

    return of


def motion(model, row=1, axis=0):
    """t and coordinate at every cycle."""
    return np.array([(s.t, s.x[row, axis]) for s in steps(model)]).T


def oscillator(model, zeta=0.0, offset=0.1, tssfac=0.1, end=1.0):
    """m = 0.5, k = 200 (omega = 20), released from an elongation `offset`, with a damper of ratio zeta beside."""
    deck = MASS + SPRING.format(k=200.0) + f"*ELEMENT_DISCRETE\n1,1,1,2,0,0.0,0,{offset}\n"
    if zeta:
        deck += DAMPER.format(c=20.0 * zeta) + "*ELEMENT_DISCRETE\n2,2,1,2\n"
    return model(deck, end, tssfac)


def test_frequency_is_that_of_central_differences(model):
    """The undeformed length is at x = 1.9: x = 1.9 + 0.1 cos(2/dt asin(omega dt/2) t) at every step."""
    t, x = motion(oscillator(model, tssfac=0.3))
    numeric = 2.0 / t[1] * math.asin(20.0 * t[1] / 2.0)
    assert t[1] == pytest.approx(0.3 * 2.0 / 20.0, rel=1e-14)
    np.testing.assert_allclose(x, 1.9 + 0.1 * np.cos(numeric * t), atol=1e-13)


def test_order_is_two_without_and_one_with_a_damper(model):
    for zeta, order in ((0.0, 2.0), (0.2, 1.0)):
        errors = []
        for tssfac in (0.02, 0.01, 0.005):
            t, x = motion(oscillator(model, zeta, tssfac=tssfac))
            damped = 20.0 * math.sqrt(1.0 - zeta**2)
            swing = np.cos(damped * t) + 20.0 * zeta / damped * np.sin(damped * t)
            errors.append(np.abs(x - 1.9 - 0.1 * np.exp(-20.0 * zeta * t) * swing).max())
        np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), order, atol=0.05)


def test_lone_damper_decays_as_its_difference_equation(model):
    """v_{n+1/2} = (1 - c dt/m) v_{n-1/2}, after a first step of half as much, along a fixed direction to the ground."""
    m = model(
        MASS
        + DAMPER.format(c=4.0)
        + "*DEFINE_SD_ORIENTATION\n7,0,3.0,0,0\n*ELEMENT_DISCRETE\n2,2,2,0,7\n*INITIAL_VELOCITY_NODE\n2,1.5\n"
    )
    v = np.array([s.v[1, 0] for s in steps(m)])
    dt = m.state.dt
    assert dt == pytest.approx(0.1 * 2.0 * 0.5 / 4.0, rel=1e-14)
    np.testing.assert_allclose(v[2:] / v[1:-1], 1.0 - 4.0 * dt / 0.5, rtol=1e-12)
    assert v[1] / 1.5 == pytest.approx(1.0 - 4.0 * dt / 2.0 / 0.5, rel=1e-12)


@pytest.mark.parametrize("zeta", [0.0, 0.5, 2.0])
def test_limit_of_spring_and_damper_is_the_true_one(model, zeta):
    """(2/omega)(sqrt(1 + zeta^2) - zeta), though they are two parts: stable at 0.99, unstable at 1.01."""
    for tssfac in (0.99, 1.01):
        m = oscillator(model, zeta, tssfac=tssfac, end="1e6,1000")
        if tssfac < 1.0:
            _, x = motion(m)
            assert np.abs(x - 1.9).max() < 1.0
        else:
            with pytest.raises(SolverError, match="diverged"):
                motion(m)
        assert m.state.dt == pytest.approx(tssfac * 0.1 * (math.sqrt(1.0 + zeta**2) - zeta), rel=1e-12)


def test_limit_of_a_chain_is_safe_and_near():
    """Against 2/omega_max of the assembled matrices, for masses and stiffnesses of all sizes."""
    rng = np.random.default_rng(5)
    for _ in range(50):
        n = 6
        nodes = np.array([(i, i + 1) for i in range(n - 1)] + [(0, -1)])
        k, mass = 10.0 ** rng.uniform(-2, 2, len(nodes)), 10.0 ** rng.uniform(-1, 1, n)
        sums, K = np.zeros(n), np.zeros((n, n))
        for (a, b), one in zip(nodes, k, strict=True):
            ends = [a, b] if b >= 0 else [a]
            sums[ends] += one
            K[np.ix_(ends, ends)] += one * np.outer([1, -1], [1, -1])[: len(ends), : len(ends)]
        exact = 2.0 / math.sqrt(np.linalg.eigvals(K / mass[:, None]).real.max())
        found = stable_step(nodes, sums, np.zeros(n), mass)
        assert exact / math.sqrt(2.0) * 0.99 <= found <= exact * (1.0 + 1e-12)


def test_limit_of_a_lone_spring_between_two_masses():
    pair = np.array([[0, 1]])
    found = stable_step(pair, np.full(2, 30.0), np.zeros(2), np.array([2.0, 0.5]))
    assert found == pytest.approx(2.0 * math.sqrt(2.0 * 0.5 / (2.5 * 30.0)), rel=1e-14)
    assert stable_step(pair, np.zeros(2), np.zeros(2), np.ones(2)) == math.inf
    assert stable_step(pair, np.full(2, 30.0), np.zeros(2), np.zeros(2)) == math.inf  # both held


PAIR = "*NODE\n1,1.0,0,0\n2,2.0,0,0\n*ELEMENT_MASS\n1,1,2.0\n2,2,1.0\n"
LENGTHS = "*INITIAL_VELOCITY_NODE\n1,0,-0.7,0.2\n2,0,1.4,-0.4\n"


def test_free_pair_keeps_both_momenta_and_its_length_is_the_exact_one(model):
    m = model(PAIR + SPRING.format(k=50.0) + "*ELEMENT_DISCRETE\n8,1,1,2\n" + LENGTHS, end=10.0, tssfac=0.5)
    mass = m.state.mass[:, None]
    elongation, axial = (probe(m, discrete=8, component=name) for name in ("elongation", "force"))
    start = mass * m.state.v
    spin = np.cross(m.state.x, start).sum(axis=0)
    turned = []
    for s in steps(m):
        r = s.x[1] - s.x[0]
        assert elongation() == pytest.approx(np.linalg.norm(r) - 1.0, abs=1e-12)
        assert axial() == pytest.approx(50.0 * elongation(), rel=1e-14)
        np.testing.assert_allclose(s.f[1], -axial() * r / np.linalg.norm(r), atol=1e-12)  # tension pulls back
        np.testing.assert_allclose(s.f.sum(axis=0), 0.0, atol=1e-13)
        # x_n and v_{n-1/2}: angular momentum of leapfrog, conserved by central forces
        np.testing.assert_allclose(np.cross(s.x, mass * s.v).sum(axis=0), spin, atol=1e-12)
        turned.append(math.atan2(r[1], r[0]))
    np.testing.assert_allclose((mass * m.state.v).sum(axis=0), start.sum(axis=0), atol=1e-12)
    assert np.ptp(np.unwrap(turned)) > 2.0 * math.pi


def test_stretched_spring_in_steady_rotation_keeps_its_length(model):
    """k d = m omega^2 L for each of two masses 1 at L = 1.25, rest length 1: no vibration, whole turns."""
    turn = math.sqrt(2.0 * 50.0 * 0.25 / 1.25)
    fast = turn * 1.25 / 2.0
    deck = "*NODE\n1,-0.625,0,0\n2,0.625,0,0\n*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n" + SPRING.format(k=50.0)
    deck += f"*ELEMENT_DISCRETE\n1,1,1,2,0,0.0,0,0.25\n*INITIAL_VELOCITY_NODE\n1,0,{-fast}\n2,0,{fast}\n"
    m = model(deck, end=4.0 * math.pi / turn, tssfac=0.02)
    stored = m.forces[0].energy["spring and damper"]
    lengths, energies = np.array([(np.linalg.norm(s.x[1] - s.x[0]), stored[0]) for s in steps(m)]).T
    dt = m.state.dt
    np.testing.assert_allclose(lengths, 1.25, rtol=(turn * dt) ** 2)
    np.testing.assert_allclose(energies, 0.5 * 50.0 * 0.25**2, rtol=10.0 * (turn * dt) ** 2)


def test_damper_does_not_resist_rigid_rotation(model):
    deck = PAIR.replace("2,2,1.0", "2,2,2.0") + DAMPER.format(c=30.0) + "*ELEMENT_DISCRETE\n1,2,1,2\n"
    m = model(deck, tssfac=0.01)
    next(steps(m))
    s = m.state
    m.forces[0].force[:] = 0.0
    angle = 0.3  # x_n from x_{n-1} by a rotation: the chord, not the tangent, is dt v
    R = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
    before = s.x.copy()
    s.x[:] = before @ R.T
    s.dt = 0.01
    s.v[:] = (s.x - before) / s.dt
    m.forces[0].add(s)
    assert abs(m.forces[0].force[0]) < 1e-12


def test_energy_of_spring_and_damper_balances(model):
    """Kinetic + stored + dissipated = stored at the start, to m dt^2/8 (a_n^2 - a_0^2), damped or not."""
    for zeta in (0.0, 0.3):
        m = oscillator(model, zeta, tssfac=0.1)
        ratio, total = probe(m, energy="ratio"), probe(m, energy="total")
        assert total() == pytest.approx(0.5 * 200.0 * 0.1**2, rel=1e-12)
        history = np.array([(s.a[1, 0], total(), ratio()) for s in steps(m)])
        a, dt = history[:, 0], m.state.dt
        expected = history[0, 1] + 0.5 * dt**2 / 8.0 * (a**2 - a[0] ** 2)
        np.testing.assert_allclose(history[:, 1], expected, rtol=1e-11)
        np.testing.assert_allclose(history[:, 2], history[:, 1] / history[0, 1], rtol=1e-14)


def test_ground_and_orientation(model):
    """Along (1, 1, 0)/sqrt 2 to the ground: a force against the motion along it, none across; OFFSET pulls at once."""
    deck = "*NODE\n1,0,0,0\n*ELEMENT_MASS\n1,1,1.0\n*DEFINE_SD_ORIENTATION\n4,0,2.0,2.0,0\n" + SPRING.format(
        k=9.0
    )
    m = model(
        deck + "*ELEMENT_DISCRETE\n1,1,1,0,4\n*INITIAL_VELOCITY_NODE\n1,0.2,0.0,0.1\n", end=3.0, tssfac=0.01
    )
    t, x = motion(m, 0, 0)
    np.testing.assert_allclose(x, 0.1 * t + 0.1 / 3.0 * np.sin(3.0 * t), atol=2e-5)
    m = model(deck + "*ELEMENT_DISCRETE\n1,1,1,0,4,0.0,0,0.5\n")
    next(steps(m))
    pull = 9.0 * 0.5 / math.sqrt(2.0)
    np.testing.assert_allclose(
        m.state.f[0], [pull, pull, 0.0], rtol=1e-14
    )  # tension pulls node 1 along the axis


SPATIAL = """*NODE
1,0,0,0,7,7
2,3.0,0,4.0
3,0,0,1.0,7,7
4,0,0,3.0,7,7
5,1.0,1.0,1.0,7,7
*ELEMENT_MASS
1,2,0.5
*INITIAL_VELOCITY_NODE
2,0.3,2.0,-1.0
""" + SPRING.format(k=50.0)


def oriented(model, card, vid=4):
    """Path of node 2 and elongation of a spring in space that begins in flight."""
    deck = SPATIAL + (f"*DEFINE_SD_ORIENTATION\n{vid},{card}\n" if card else "")
    m = model(deck + f"*ELEMENT_DISCRETE\n1,1,1,2,{vid if card else 0},0.0,0,0.2\n", end=2.0, tssfac=0.05)
    elongation, total = probe(m, discrete=1, component="elongation"), probe(m, energy="total")
    rows = [(*s.x[1], *s.f[1], elongation(), total()) for s in steps(m)]
    return np.array(rows)


@pytest.mark.parametrize("card", ["1,0,0,7.0", "3,0,0,0,3,4"])
def test_projection_on_a_plane(model, card):
    """Normal z, by its vector or between nodes: the length in the plane is stretched, nothing acts along z."""
    x, y, z, fx, fy, fz, elongation, total = oriented(model, card).T
    length = np.hypot(x, y)
    np.testing.assert_allclose(elongation, 0.2 + length - 3.0, atol=1e-12)
    np.testing.assert_allclose([fx, fy], -50.0 * elongation * np.array([x, y]) / length, atol=1e-10)
    assert not fz.any()
    np.testing.assert_allclose(z[-1], 4.0 - 2.0, atol=0.05)
    np.testing.assert_allclose(total, total[0], rtol=2e-3)


def test_the_line_between_two_nodes(model):
    """Its own nodes: as without an orientation; two held nodes: as the vector between them."""
    np.testing.assert_array_equal(oriented(model, "2,0,0,0,1,2"), oriented(model, ""))
    np.testing.assert_allclose(
        oriented(model, "2,0,0,0,3,5"), oriented(model, "0,2.0,2.0,0.0"), rtol=1e-12, atol=1e-12
    )


def test_a_line_that_turns_with_its_nodes_does_not_stretch(model):
    """Spring and guide on one turning line: no elongation, however far they turn."""
    deck = "*NODE\n1,-1,0,0\n2,1,0,0\n3,-2,0,0\n4,2,0,0\n*ELEMENT_MASS\n" + "".join(
        f"{n},{n},{m}\n" for n, m in ((1, 0.5), (2, 0.5), (3, 0.25), (4, 0.25))
    )
    deck += SPRING.format(k=1e-12) + "*DEFINE_SD_ORIENTATION\n4,2,0,0,0,3,4\n*ELEMENT_DISCRETE\n1,1,1,2,4\n"
    m = model(deck, end=5.0)
    block, s = m.forces[0], m.state
    block.add(s)
    s.dt = 0.5
    for n in range(1, 20):
        before = s.x.copy()
        s.x[:] = m.x0[:, :1] * [math.cos(0.3 * n), math.sin(0.3 * n), 0.0]
        s.v[:] = (s.x - before) / s.dt
        block.add(s)
        assert abs(block.elongation[0]) < 1e-14


def clearance(model, v, fields):
    """A mass at x = 2 with velocity v and a spring of k = 200 to the origin; t, x, force."""
    deck = (
        MASS + SPRING.format(k=200.0).replace("1,1,1", "1,3,1") + f"*SECTION_DISCRETE\n3,0,0,0,{fields}\n\n"
    )
    m = model(deck + f"*ELEMENT_DISCRETE\n1,1,1,2\n*INITIAL_VELOCITY_NODE\n2,{v}\n", end=0.4, tssfac=0.01)
    force, total = probe(m, discrete=1, component="force"), probe(m, energy="total")
    return np.array([(s.t, s.x[1, 0], force(), total()) for s in steps(m)]).T


def test_a_spring_with_clearance_bears_compression_alone(model):
    """After 0.1 at speed 1: half a sine of omega = 20 and amplitude v/omega, then back; no force in tension."""
    t, _, f, total = clearance(model, -1.0, 0.1)
    contact = (t > 0.1) & (t < 0.1 + math.pi / 20.0)
    np.testing.assert_allclose(f[contact], -200.0 / 20.0 * np.sin(20.0 * (t[contact] - 0.1)), atol=0.02)
    assert not f[t < 0.1].any()
    assert not f[t > 0.105 + math.pi / 20.0].any()
    np.testing.assert_allclose(total, total[0], rtol=1e-3)
    assert not clearance(model, 1.0, 0.1)[2].any()


@pytest.mark.parametrize(("v", "fd"), [(1.0, 0.03), (-1.0, -0.03)])
def test_a_spring_breaks_at_its_failure_deflection_for_good(model, v, fd):
    """v/omega = 0.05 would be reached: at 0.03 the force ends, and the velocity stays at 0.8 v."""
    t, x, f, _ = clearance(model, v, f"0,{fd}")
    d = (x - 2.0) * np.sign(v)
    broken = np.flatnonzero(d > 0.03)
    assert broken[0] > 10
    assert not f[broken[0] :].any()
    np.testing.assert_allclose(f[: broken[0]], 200.0 * np.sign(v) * d[: broken[0]], rtol=1e-12)
    np.testing.assert_allclose(np.diff(d[broken]) / np.diff(t[broken]), 0.8, rtol=5e-3)
    assert np.abs(f).max() == pytest.approx(6.0, rel=0.02)
    t, x, f, _ = clearance(model, -v, f"0,{fd}")
    other = t < math.pi / 20.0  # the half of the swing in the other direction
    np.testing.assert_allclose(f[other], 200.0 * (x[other] - 2.0), rtol=1e-12, atol=1e-12)


def test_s_scales_force_energy_and_stable_step(model):
    deck = MASS + SPRING.format(k=100.0)
    once = model(deck + "*ELEMENT_DISCRETE\n1,1,1,2,0,4.0,0,0.1\n")
    four = model(MASS + SPRING.format(k=400.0) + "*ELEMENT_DISCRETE\n1,1,1,2,0,0.0,0,0.1\n")
    np.testing.assert_array_equal(motion(once), motion(four))
    assert once.forces[0].energy["spring and damper"][0] == four.forces[0].energy["spring and damper"][0]


TORSION = """*PART
plate
9,9,9
*SECTION_SHELL
9,2
0.1
*MAT_ELASTIC
9,1.0,1e-8,0.0
*NODE
1,0,0,0,7,7
2,1,0,0,7,0
3,1,1,0,7,7
4,0,1,0,7,7
*ELEMENT_SHELL
1,9,1,2,3,4
*PART
torsion spring
1,2,1
*MAT_SPRING_ELASTIC
1,5.0
*DEFINE_SD_ORIENTATION
3,0,0,0,1.0
*ELEMENT_DISCRETE
1,1,1,2,{vid},0.0,0,{offset}
"""


@pytest.mark.parametrize(("vid", "axis"), [(0, 0), (3, 2)])
def test_torsion_spring_turns_a_node_about_its_axis(model, vid, axis):
    """theta = theta_0 cos(sqrt(K/I) t), with the rotary inertia of the corner of a shell much softer than the spring."""
    m = model(TORSION.format(vid=vid, offset=0.2), end=0.05, tssfac=0.02)
    inertia = m.state.inertia[1]
    omega = math.sqrt(5.0 / inertia)
    rotation, moment = (probe(m, discrete=1, component=name) for name in ("rotation", "moment"))
    t, theta, M = np.array([(s.t, rotation(), moment()) for s in steps(m)]).T
    assert t[1] == pytest.approx(0.02 * 2.0 / (math.sqrt(2.0) * omega), rel=1e-9)  # both ends have inertia
    assert omega * t[-1] > 1.0
    np.testing.assert_allclose(theta, 0.2 * np.cos(omega * t), atol=2e-3 * 0.2)
    np.testing.assert_allclose(M, 5.0 * theta, rtol=1e-13)
    others = [i for i in range(3) if i != axis]
    assert np.abs(m.state.omega[1, others]).max() < 1e-3 * abs(m.state.omega[1, axis])
    assert energy.kinetic(m.state) > 0.0


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("1,1,1,2,0", "1,1,1,0,0", r"\*ELEMENT_DISCRETE: VID = 0: an element to the ground \(N2 = 0\) needs an orientation"),
        ("1,1,1,2,0", "1,1,1,2,5", r"\*ELEMENT_DISCRETE: VID = 5: no \*DEFINE_SD_ORIENTATION with VID = 5; defined: none"),
        ("1,1,1,2,0", "1,1,1,7,0", r"\*ELEMENT_DISCRETE: N2 = 7: no \*NODE 7"),
        ("1,1,1,2,0", "1,1,0,2,0", r"\*ELEMENT_DISCRETE: N1 = 0: must be greater than 0"),
        ("2,2.0,0,0", "2,0.0,0,0", r"\*ELEMENT_DISCRETE: VID = 0: an element between nodes at one place needs an orientation"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5,4", r"\*DEFINE_SD_ORIENTATION: IOP = 4: only 0, 1, 2 and 3 are supported"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5,2,1.0", r"\*DEFINE_SD_ORIENTATION: IOP = 2: takes the direction between its nodes"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5,2,0,0,0,1,8", r"\*DEFINE_SD_ORIENTATION: NID2 = 8: no \*NODE 8"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5,3,0,0,0,2,2", r"\*DEFINE_SD_ORIENTATION: NID2 = 2: lies where NID1 is"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5,1,1.0,0,0,2", r"\*DEFINE_SD_ORIENTATION: NID1 = 2: only IOP = 2 and 3 have nodes"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5,1,1.0", r"\*ELEMENT_DISCRETE: VID = 5: nothing of the element lies in the plane"),
        ("1,1,1,2,0", "1,1,1,0,5\n*DEFINE_SD_ORIENTATION\n5,1,1.0", r"\*ELEMENT_DISCRETE: VID = 5: an element to the ground \(N2 = 0\) needs an orientation, IOP 0 or 2"),
        ("1,1,1,2,0", "1,1,1,2,5\n*DEFINE_SD_ORIENTATION\n5", r"\*DEFINE_SD_ORIENTATION: XT = 0.0: the vector XT, YT, ZT has no length"),
        ("*SECTION_DISCRETE\n1", "*SECTION_DISCRETE\n1,0,0.3", r"\*SECTION_DISCRETE: KD = 0.3: only 0.0 is supported"),
        ("1,1,1\n", "1,9,1\n", r"\*PART: SECID = 9: no \*SECTION_DISCRETE with SECID = 9; defined: 1, 2"),
        ("*MAT_SPRING_ELASTIC\n1,1.0", "*MAT_ELASTIC\n1,1.0,1.0", r"\*PART: MID = 1: \*MAT_ELASTIC has no law for spring; these have one: \*MAT_DAMPER_NONLINEAR_VISCOUS, .*\*MAT_SPRING_ELASTIC"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_with_card_and_field(deck, old, new, message):
    text = HEAD.format(end=1.0, tssfac=0.1) + MASS + SPRING.format(k=1.0) + "*ELEMENT_DISCRETE\n1,1,1,2,0\n"
    assert old in text
    with pytest.raises(DeckError, match=message):
        build(deck(text.replace(old, new, 1)))


def test_clearance_is_for_elastic_springs(deck):
    text = HEAD.format(end=1.0, tssfac=0.1).replace("2,1\n", "2,0,0,0,0.1\n") + MASS
    text += DAMPER.format(c=1.0).replace("2,1,2", "2,2,2") + "*ELEMENT_DISCRETE\n1,2,1,2\n"
    with pytest.raises(
        DeckError, match=r"CL = 0.1: not supported with \*MAT_DAMPER_VISCOUS: elastic springs are"
    ):
        build(deck(text))


def test_channels_say_what_there_is(model):
    m = oscillator(model)
    with pytest.raises(
        ProbeError, match="no 'moment' of this discrete element; there are: force, elongation"
    ):
        probe(m, discrete=1, component="moment")


BAR = """*PART
bar
3,3,3
*SECTION_BEAM
3,3
1.0
*MAT_ELASTIC
3,0.5,400.0
*ELEMENT_BEAM
7,3,1,2
"""  # k = 200, and 0.5 to each node


@pytest.mark.parametrize("held", [True, False])
@pytest.mark.parametrize("k", [1e-6, 100.0, 400.0, 1e4])
def test_a_bar_and_a_spring_at_one_node_share_its_mass(model, held, k):
    """Either alone would allow 2/sqrt(2 k/m), at which both together diverge; the true limit is that of the matrix."""
    nodes = f"*NODE\n1,0,0,0,{7 if held else 5},7\n2,2.0,0,0,5,7\n*DEFINE_SD_ORIENTATION\n1,0,1.0\n"
    spring = SPRING.format(k=k) + "*ELEMENT_DISCRETE\n1,1,2,0,1\n*INITIAL_VELOCITY_NODE\n2,1e-6\n"
    made = model(nodes + spring + BAR, end=1e9, tssfac=1.0)
    run = steps(made)
    found = next(run).x[1, 0] and made.next_step()
    stiffness = np.array([[200.0, -200.0], [-200.0, 200.0 + k]]) / 0.5
    true = 2.0 / math.sqrt(stiffness[1, 1] if held else np.linalg.eigvalsh(stiffness)[-1])
    own = min(2.0 / math.sqrt(2.0 * 200.0 / 0.5), 2.0 / math.sqrt(k / 0.5))
    assert 0.7 * own <= found <= own
    assert found <= true * (1.0 + 1e-12)


def test_a_soft_spring_leaves_the_step_of_a_bar_alone():
    pair, mass, taken = np.array([[0, 1]]), np.full(2, 0.5), np.full(2, 0.5 / 0.02**2)
    assert stable_step(pair, np.full(2, 1e-3), np.zeros(2), mass, taken) == pytest.approx(0.02, rel=1e-5)
