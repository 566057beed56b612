"""*CONTROL_TIMESTEP: caps on the step, and mass scaling that reaches its aim and says what it cost."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.loop import steps

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


def timestep(dtinit=0.0, dt2ms=0.0, lctm=0, ms1st=0):
    return f"*CONTROL_TIMESTEP\n{dtinit},{TSSFAC},0,0.0,{dt2ms},{lctm},0,{ms1st}\n"


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
        (timestep(dt2ms=1e-3), r"DT2MS = 0.001: one step for all elements is not supported"),
        (timestep(dt2ms=-1e-3), r"MS1ST = 0: mass scaling during the run is not supported"),
        (timestep(lctm=7), r"LCTM = 7: no \*DEFINE_CURVE with LCID = 7"),
        (
            "*DEFINE_CURVE\n2\n0.0,1.0\n5.0,0.0\n" + timestep(lctm=2),
            r"LCTM = 2: a largest step that is not positive",
        ),
    ],
)
def test_what_is_refused(wall_and, card, message):
    with pytest.raises(DeckError, match=message):
        wall_and(SMALL + card)
