"""*CONTROL_TIMESTEP: caps on the step, and mass scaling that reaches its aim and says what it cost."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

# Free squares of sides 1 and 0.5 beside the wall of side 2: L/c = L/sqrt(3/rho).
SMALL = """*NODE
11,5,5,0
12,6,5,0
13,6,6,0
14,5,6,0
15,6.5,5,0
16,6.5,5.5,0
17,6,5.5,0
*PART
small
2,1,1
*ELEMENT_SHELL
2,2,11,12,13,14
3,2,12,15,16,17
"""
TSSFAC = 0.8


def taken(model):
    """The steps of a run."""
    return np.diff([s.t for s in steps(model)])


def timestep(dtinit=0.0, dt2ms=0.0, lctm=0, ms1st=0, tssfac=TSSFAC):
    return f"*CONTROL_TIMESTEP\n{dtinit},{tssfac},0,0.0,{dt2ms},{lctm},0,{ms1st}\n"


def side_step(side, density=1e-4):
    return side / np.sqrt(3.0 / density)


def test_dtinit_shortens_the_first_step_alone(wall_and):
    stable = TSSFAC * side_step(0.5)
    dt = taken(wall_and(SMALL + timestep(dtinit=1e-5), end=0.1))
    assert dt[0] == pytest.approx(1e-5, rel=1e-12)
    np.testing.assert_allclose(dt[1:], stable, rtol=1e-9)
    np.testing.assert_allclose(taken(wall_and(SMALL + timestep(dtinit=1.0), end=0.1)), stable, rtol=1e-9)


def test_lctm_caps_the_step_over_time(wall_and):
    curve = "*DEFINE_CURVE\n2\n0.0,1e-3\n0.05,1e-3\n0.0501,1.0\n0.2,1.0\n"
    model = wall_and(SMALL + curve + timestep(lctm=2), end=0.1)
    t = np.array([s.t for s in steps(model)])
    early = t[:-1] <= 0.05
    np.testing.assert_allclose(np.diff(t)[early], 1e-3, rtol=1e-9)
    np.testing.assert_allclose(np.diff(t)[~early][1:], TSSFAC * side_step(0.5), rtol=1e-9)


def test_mass_scaling_reaches_its_step_and_reports_the_mass(wall_and):
    plain = wall_and(SMALL + timestep())
    aim = 1.5 * side_step(0.5)  # below that of the shell of side 1
    model = wall_and(SMALL + timestep(dt2ms=-aim, ms1st=1), end=0.1)
    np.testing.assert_allclose(taken(model), TSSFAC * aim, rtol=1e-12)
    rows = np.searchsorted(model.ids, [12, 15, 16, 17])
    own = 1e-4 * 0.1 * 0.25  # rho t A of the small shell
    gained = model.state.mass - plain.state.mass
    np.testing.assert_allclose(gained[rows], (1.5**2 - 1.0) * own / 4, rtol=1e-12)
    assert np.count_nonzero(gained) == 4
    np.testing.assert_allclose(model.state.inertia[15 - 7], 1.5**2 * plain.state.inertia[15 - 7], rtol=1e-12)
    whole = own * 5  # with the shell of side 1
    assert model.facts == {
        "Mass added to shells of part 2": f"{1.25 * own:.6g} ({125.0 * own / whole:.4g} %), at 1 of 2 elements"
    }


def test_mass_scaling_leaves_what_is_slow_enough(wall_and):
    model = wall_and(SMALL + timestep(dt2ms=-0.5 * side_step(0.5), ms1st=1))
    assert model.facts == {}
    assert model.state.mass.tolist() == wall_and(SMALL).state.mass.tolist()


@pytest.mark.parametrize(
    ("card", "message"),
    [
        (timestep(dt2ms=1e-3), r"DT2MS = 0.001: a positive DT2MS is not supported; give a negative value"),
        (
            "*BOUNDARY_PRESCRIBED_MOTION_NODE\n15,1,0,1,1.0,0,0.5\n" + timestep(dt2ms=-1e-3),
            r"MS1ST = 0: not supported with prescribed motion 1, which is not throughout",
        ),
        (timestep(lctm=7), r"LCTM = 7: no \*DEFINE_CURVE with LCID = 7"),
        (
            "*DEFINE_CURVE\n2\n0.0,1.0\n5.0,0.0\n" + timestep(lctm=2),
            r"LCTM = 2: the largest step must be positive",
        ),
    ],
)
def test_what_is_refused(wall_and, card, message):
    with pytest.raises(DeckError, match=message):
        wall_and(SMALL + card)


# A bar and a beam of length 1, far from the wall: sqrt(L L_0)/c and L/c with c = sqrt(E/rho) = 100, the smallest steps.
BARS = """*NODE
21,5,5,5
22,6,5,5
23,7,5,5
24,8,5,5
25,7,6,5
*PART
bar
3,3,3
*PART
beam
4,4,3
*SECTION_BEAM
3,3
0.2
*SECTION_BEAM
4,2
0.2,1e-4,1e-4,2e-4
*MAT_ELASTIC
3,1e-3,10.0,0.0
*ELEMENT_BEAM
3,3,21,22
4,4,23,24,25
*ELEMENT_MASS
1,21,3e-4
"""


@pytest.mark.parametrize("ms1st", [0, 1])
def test_bars_and_beams_are_scaled(wall_and, ms1st):
    rest = "*BOUNDARY_SPC_NODE\n25,0,1,1,1,1,1,1\n"
    plain = wall_and(BARS + rest + timestep())
    model = wall_and(BARS + rest + timestep(dt2ms=-0.02, ms1st=ms1st), end=0.2)
    np.testing.assert_allclose(taken(plain), TSSFAC * 0.01, rtol=1e-12)
    np.testing.assert_allclose(taken(model), TSSFAC * 0.02, rtol=1e-12)
    phi, rows = 4.0, np.searchsorted(model.ids, [21, 22, 23, 24])
    own = 1e-3 * 0.2 / 2  # of each node
    np.testing.assert_allclose((model.state.mass - plain.state.mass)[rows], (phi - 1) * own, rtol=1e-12)
    inertia = plain.state.inertia[rows]
    assert (inertia[2:] > 0.0).all()
    np.testing.assert_allclose(model.state.inertia[rows], phi * inertia, rtol=1e-12)
    assert sum("Mass added" in name for name in model.facts) == 3  # with the wall
    assert model.facts["Mass added to trusses of part 3"] == f"{6 * own:.6g} (300 %), at 1 of 1 elements"


def test_springs_are_not_scaled_and_it_is_said(wall_and):
    spring = """*PART
spring
5,5,5
*SECTION_DISCRETE
5,0

*MAT_SPRING_ELASTIC
5,50.0
*ELEMENT_DISCRETE
5,5,11,12
"""
    model = wall_and(SMALL + spring + timestep(dt2ms=-1e-3, ms1st=1))
    assert "springs and dampers" in model.facts["Mass scaling"]


def test_mass_added_during_the_run_keeps_momentum_and_its_energy_is_accounted_for(wall_and):
    """A free bar and a free beam whose ends run into each other: shorter and shorter, until they bounce."""
    flight = "".join(
        f"*INITIAL_VELOCITY_NODE\n{nid},{v},0.0,0.0\n"
        for nid, v in ((21, 3.0), (22, -4.0), (23, 1.0), (24, -4.0))
    )
    rest = "*BOUNDARY_SPC_NODE\n25,0,1,1,1,1,1,1\n"
    aim = 0.0099
    model = wall_and(BARS + flight + rest + timestep(dt2ms=-aim, tssfac=0.02), end=0.02)
    s, rows = model.state, np.searchsorted(model.ids, [21, 22, 23, 24])
    total, momentum, mass, step = probe(model, energy="total"), [], [], []
    energy = []
    for _ in steps(model):
        v = s.v[rows, 0] + 0.5 * s.dt * s.a[rows, 0]
        momentum.append([s.mass[rows[:2]] @ v[:2], s.mass[rows[2:]] @ v[2:]])
        mass.append(s.mass[rows].copy())
        energy.append(total())
        step.append(s.dt)
    gained = mass[-1] / mass[0]
    assert (gained[1:] > 1.02).all()
    np.testing.assert_allclose(momentum, np.broadcast_to(momentum[0], (len(momentum), 2)), rtol=1e-12)
    assert model.constraints[-1].energy["damping"][0] > 0.002 * energy[0]
    assert np.ptp(energy) < 1e-3 * energy[0]
    assert min(step[1:]) > 0.999 * 0.02 * aim


def test_a_prescribed_motion_drags_the_new_mass_along(wall_and):
    """An end that is driven keeps its velocity; the work that its new mass takes is external."""
    drive = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n22,1,0,1,-2.0\n"
    rest = "*BOUNDARY_SPC_NODE\n21,0,1,1,1,1,1,1\n23,0,1,1,1,1,1,1\n24,0,1,1,1,1,1,1\n25,0,1,1,1,1,1,1\n"
    model = wall_and(BARS + drive + rest + timestep(dt2ms=-0.0099), end=0.2)
    total, work = probe(model, energy="total"), probe(model, energy="external work")
    energy = np.array([(total(), work()) for _ in steps(model)])
    row = int(np.searchsorted(model.ids, 22))
    assert model.state.v[row, 0] == pytest.approx(-2.0, rel=1e-12)
    scaling = model.constraints[-1]
    gained = model.state.mass[row] - 1e-4
    assert gained > 2e-5
    assert scaling.energy["external work"][0] == pytest.approx(0.5 * gained * 4.0, rel=1e-9)
    assert scaling.energy["damping"][0] == 0.0
    put_in = energy[0, 0] + energy[:, 1]
    np.testing.assert_allclose(energy[:, 0], put_in, rtol=1e-3)


def test_a_spring_at_a_scaled_bar_has_the_stiffness_of_the_bar_before_scaling(wall_and):
    """m = phi m_e bears dt^2 (k/4 + m_e/h^2): 0.01039. With h after scaling the step would be that of DT2MS, 0.012."""
    spring = "*PART\nspring\n5,5,5\n*SECTION_DISCRETE\n5\n\n*MAT_SPRING_ELASTIC\n5,{}\n*ELEMENT_DISCRETE\n5,5,22,0,1\n"
    rest = "*BOUNDARY_SPC_NODE\n25,0,1,1,1,1,1,1\n*DEFINE_SD_ORIENTATION\n1,0,1.0\n"
    k, m, h, aim = 4.0 / 3.0, 1e-4, 0.01, 0.015
    model = wall_and(BARS + rest + spring.format(k) + timestep(dt2ms=-aim), end=0.05)
    expected = TSSFAC * np.sqrt((aim / h) ** 2 * m / (k / 4.0 + m / h**2))
    assert expected == pytest.approx(0.01039, abs=5e-6)
    np.testing.assert_allclose(taken(model)[0], expected, rtol=1e-6)
