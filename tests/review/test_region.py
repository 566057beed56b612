"""Data for which the events of a case do not happen."""

from pathlib import Path

import pytest

from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.case.settings import RegionError, with_settings
from vmharness.review.region import outside

CASES = Path(__file__).parents[2] / "cases"
LEVEL = ('at = "T"', 'crossing_of = "z", level = "-1.0*T/T*z_0", direction = "down"')
HEIGHT = ("[theory]\n", '[theory]\nz_0  = { formula = "1.0*g*T^2", text = "Twice the height of fall" }\n')
KINETIC = (
    'channel   = "z"\ntarget    = "z_T"\nunit      = "m"',
    'channel = "kinetic"\ntarget = "ke_T"\nunit = "J"',
)


def sentences(own, **data):
    case = with_settings(own, data)
    return outside(case, data, own, read_deck(case))


@pytest.mark.parametrize("id", sorted(path.parent.name for path in CASES.glob("*/case.toml")))
def test_every_case_lies_in_its_own_region(id):
    case = read(CASES / id)
    data = {name: case.datum(name) for name in case.given if case.moves_deck(name)}
    assert outside(case, data, case, read_deck(case)) == []


def test_the_range_of_the_sweep_is_named():
    ball = read(CASES / "VM-061")
    assert sentences(ball, k=8000.0) == []
    assert sentences(ball, k=9000.0) == ["k = 9000 is outside the region of the case, 500 to 8000 lbf/in"]


def test_a_constraint_of_the_sweep_is_named_with_its_reason():
    found = sentences(read(CASES / "D-20"), v1=1.0, v2=0.5)
    assert "dv/v1 = 0.5" not in found
    found = sentences(read(CASES / "D-32"), I1=0.5, I3=4.0)
    assert found[0].startswith("I3/I1 = 8 is outside the region of the case, 0.7 to 2: no moment of inertia")


def test_data_without_a_value_of_theory_are_outside(fall):
    with pytest.raises(RegionError, match=r"sqrt"):
        with_settings(read(fall(('-g*T^2/2"', '-sqrt(g)*T*sqrt(g)*T/2"'))), {"g": -9.81})


def test_an_event_beyond_the_end_is_outside(fall):
    own = read(fall(('TEND = "t_end"\n', "")))
    assert sentences(own, g=5.0) == []
    pair = f"RTEND     {'0.6':>10}RDT       {'0.5':>10}"
    late = read(fall(('TEND = "t_end"\n', 'DT = "T"\n'), ("RTEND          0.6", pair)))
    assert sentences(late, T=0.7) == ["[events] then: at = T is 0.7, but the run of the deck ends at 0.6"]


def test_an_event_that_theory_does_not_have_is_outside(fall):
    # the level is reached at sqrt(2) T, after the end at 1.2 T
    (sentence,) = sentences(read(fall(LEVEL, HEIGHT, KINETIC)), g=5.0)
    assert sentence.startswith("[events] then: by theory: At the Time T: did not happen within the run")
    assert sentences(read(fall(LEVEL, HEIGHT, KINETIC, ("1.2*T", "1.5*T"))), g=5.0) == []
