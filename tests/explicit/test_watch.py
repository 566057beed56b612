"""Energies that cannot be: what makes a run unfit to be judged, and what does not."""

import re

import pytest

from vmharness.backends import builtin
from vmharness.backends.protocol import Job
from vmharness.case.format import Channel
from vmharness.explicit.build import build
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.watch import Watch

# A plate that meets a held plate of steel at 1 m/s.
REBOUND = """*KEYWORD
*CONTROL_TERMINATION
{end}
*CONTROL_TIMESTEP
0.0,{tssfac}
*CONTROL_CONTACT
{slsfac}

*NODE
1,0.0,0.0,0.0,7,7
2,1.0,0.0,0.0,7,7
3,1.0,1.0,0.0,7,7
4,0.0,1.0,0.0,7,7
5,0.2,0.2,0.0105
6,0.8,0.2,0.0105
7,0.8,0.8,0.0105
8,0.2,0.8,0.0105
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,5,6,7,8
*PART
held
1,1,1
*PART
free
2,1,1
*SECTION_SHELL
1,2
0.01
*MAT_ELASTIC
1,7800.0,2e11,0.3
*SET_NODE_LIST
1
5,6,7,8
*INITIAL_VELOCITY
1
0.0,0.0,-1.0
*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE
1,2,3,3
0.0,0.0,0.0,0.0,{vdc}

"""


@pytest.fixture
def rebound(deck):
    """The last state and what is wrong with a run of such a deck."""

    def run(tssfac=0.9, slsfac=0.1, end=0.002, vdc=0.0):
        model = build(deck(REBOUND.format(tssfac=tssfac, slsfac=slsfac, end=end, vdc=vdc)))
        watch = Watch(model)
        try:
            for _ in steps(model, watch):
                pass
        except SolverError as error:
            return model.state, str(error)
        return model.state, watch.impossible()

    return run


@pytest.mark.parametrize("tssfac", [0.52, 0.48, 0.4, 0.3])
def test_a_contact_that_makes_or_loses_energy_is_named_with_steps_that_hold(rebound, tssfac):
    state, wrong = rebound(tssfac)
    assert abs(state.v[4, 2] ** 2 - 1.0) > 0.05
    assert "contact 1" in wrong
    assert "5 %" in wrong
    shorter, softer = re.search(r"TSSFAC = (\S+) or SLSFAC = ([^\s,]+)", wrong).groups()
    for better in ({"tssfac": float(shorter)}, {"tssfac": tssfac, "slsfac": float(softer)}):
        state, wrong = rebound(**better)
        assert wrong == ""
        assert state.v[4, 2] ** 2 == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize("tssfac", [0.9, 0.6])
@pytest.mark.parametrize("vdc", [0.0, 50.0])
def test_a_step_with_which_a_contact_would_be_unstable_is_shortened(rebound, tssfac, vdc):
    state, wrong = rebound(tssfac, vdc=vdc)
    assert wrong == ""
    assert state.v[4, 2] ** 2 == pytest.approx(1.0, abs=0.05) if vdc == 0.0 else 0.0 < state.v[4, 2] < 0.4


def test_a_contact_that_holds_says_nothing(rebound):
    assert rebound(0.12)[1] == ""
    assert rebound(0.12, vdc=50.0)[1] == ""  # a damper takes energy rightly
    assert rebound(0.9, end=0.0004)[1] == ""  # before the impact


@pytest.mark.parametrize("end", [0.0009, 0.00095, 0.0015])
def test_a_run_is_looked_at_wherever_it_ends(rebound, end):
    assert "contact energy of contact 1 has fallen to -" in rebound(0.3, end=end)[1]


def test_the_solver_reports_it_as_a_failure_with_its_history(deck, tmp_path):
    made = deck(REBOUND.format(tssfac=0.3, slsfac=0.1, end=0.002, vdc=0.0))
    output = builtin.solve(Job(made, builtin.reports(made), tmp_path))
    assert output.failure.startswith("the run cannot be judged: the contact energy of contact 1")
    assert output.history["contact"][-1] < -0.05 * output.history["kinetic"][0]


# A cantilever of shells, one in its depth, that is bent in its plane by forces at its end.
BENDING = """*KEYWORD
*CONTROL_TERMINATION
2e-3
*NODE
1,0.0,0.0,0.0,7,7
2,0.0,1.0,0.0,7,7
3,1.0,0.0,0.0
4,1.0,1.0,0.0
5,2.0,0.0,0.0
6,2.0,1.0,0.0
*ELEMENT_SHELL
1,1,1,3,4,2
2,1,3,5,6,4
*PART
beam
1,1,1
*SECTION_SHELL
1,2
0.1
*MAT_ELASTIC
1,7800.0,2e11,0.0
*LOAD_NODE_POINT
5,1,1,1e4
6,1,1,-1e4
*DEFINE_CURVE
1
0.0,1.0
1.0,1.0
"""


@pytest.mark.parametrize(("channel", "judged"), [({}, False), ({"part": 1}, True)])
def test_much_hourglass_energy_is_named_unless_the_case_is_about_it(deck, tmp_path, channel, judged):
    channels = {"hg": Channel(text="", energy="hourglass", **channel)}
    output = builtin.solve(Job(deck(BENDING), channels, tmp_path))
    if judged:
        assert output.failure == ""
    else:
        assert "the hourglass energy has come to" in output.failure
        assert "10 % of it" in output.failure
        assert "ELFORM" in output.failure


def watched(model):
    watch = Watch(model)
    for _ in steps(model, watch):
        pass
    return watch


def test_energy_that_is_made_or_lost_is_told(wall_and):
    text = "*NODE\n5,0,0,5\n*ELEMENT_MASS\n5,5,2.0\n*INITIAL_VELOCITY_NODE\n5,,,1.0\n"
    for work, said in ((-0.2, "0.2 was made"), (0.2, "0.2 was lost")):
        model = wall_and(text, end=3.0)
        watch = Watch(model)
        for s in steps(model, watch):
            if s.cycle == 5:
                watch.balance.initial += work
        assert f"the energy balance is open: {said}" in watch.impossible()
    assert watched(wall_and(text)).impossible() == ""


@pytest.mark.parametrize(
    "cards",
    [
        "*LOAD_BODY_Z\n1,9.81\n",  # external work
        "*LOAD_BODY_Z\n1,9.81\n*DAMPING_GLOBAL\n,5.0\n",
        "*RIGIDWALL_PLANAR\n0\n0,0,4.9,0,0,5.0\n",  # the ball ends on it
        "*LOAD_BODY_Z\n1,9.81\n*RIGIDWALL_PLANAR\n0\n0,0,4.9,0,0,5.0,0.3\n",
    ],
)
def test_work_damping_and_walls_open_no_balance(wall_and, cards):
    text = "*NODE\n5,0,0,5\n*ELEMENT_MASS\n5,5,2.0\n*INITIAL_VELOCITY_NODE\n5,,,-1.0\n"
    watch = watched(wall_and(text + cards))
    assert watch.impossible() == ""
    assert max(watch.balance.made, watch.balance.lost) < 0.01 * watch.balance.supplied


def test_a_vibration_near_the_stable_step_opens_no_balance(wall_and):
    # At 0.95 of it the sum of energies comes to ten times what was put in, and falls back.
    free = "*NODE\n11,5,5,0\n12,7,5,0\n13,7,7,0\n14,5,7,0\n*ELEMENT_SHELL\n2,2,11,12,13,14\n"
    part = "*PART\nfree\n2,1,2\n*MAT_ELASTIC\n2,1e-4,3.0,0.3\n"
    start = "*INITIAL_VELOCITY_NODE\n11,-1.0,-1.0\n12,1.0,-1.0\n13,1.0,1.0\n14,-1.0,1.0\n"
    assert watched(wall_and(free + part + start, end=3.0)).impossible() == ""


def test_a_model_at_rest_is_judged(wall_and):
    assert watched(wall_and("")).impossible() == ""
