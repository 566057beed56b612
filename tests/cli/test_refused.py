"""What `vm check` refuses, `vm run` refuses too, and judges the other cases; data without events are a usage error."""

import json
from pathlib import Path

import pytest

AT = ('at = "T"', 'crossing_of = "z", level = "-g*T^2/2", direction = "down"')
RUN = ("run", "--no-report", "--json", "r.json")
HELD = (
    "       1             0.0             0.0             0.0       0       0",
    "       1             0.0             0.0             0.0       7       0",
)


@pytest.fixture
def beside(fall, here):
    """Makes the case `fall` with replaced texts beside a sound one, in ./cases."""

    def make(*replacements):
        fall(id="cases/sound")
        return fall(*replacements, id="cases/fall")

    return make


@pytest.mark.parametrize(
    ("replacement", "message"),
    [
        (AT, "z at then (z): there it is the level itself"),
        (HELD, "z is held or prescribed by the deck"),
        (
            ("{ relative = 1e-6,", "{ relative = 1e300,"),
            "relative = 1e+300: it must be below the size itself",
        ),
        (
            ("{ relative = 1e-6,", "{ relative = 1e-7,"),
            "the error budget, 5e-07, exceeds the tolerance, 1e-07",
        ),
        (("RTEND          0.6", "RTEND          0.4"), "at = T is 0.5, but the run of the deck ends at 0.4"),
        (('g = "+0.1 %"', 'g = "+0.00001 %"'), "z_T must fail, but by theory it changes by only 0.1"),
        (('M    = "m"', 'MM   = "m"'), "no parameter mm to set"),
        (("RG             9.81", "RG         9.809998"), "parameter G = 9.809998, but g = 9.81"),
    ],
)
def test_a_case_that_cannot_be_judged_is_refused_alone(beside, vm, replacement, message):
    beside(replacement)
    code, printed, _ = vm("check", "fall")
    assert (code, message in printed) == (4, True)
    code, printed, _ = vm(*RUN)
    assert (code, message in printed) == (4, True)
    verdicts = {case["id"]: case["verdict"] for case in json.loads(Path("r.json").read_text())["cases"]}
    assert verdicts == {"fall": "error", "sound": "pass"}


def test_a_deck_with_another_value_fails_where_its_results_do(beside, vm):
    beside(("RG             9.81", "RG              8.0"))
    code, printed, _ = vm("check", "fall")
    assert (code, "parameter G = 8, but g = 9.81" in printed) == (4, True)
    code, printed, _ = vm(*RUN)
    assert (code, "parameter G = 8, but g = 9.81" in printed) == (1, True)


def test_a_published_value_that_cannot_be_is_mentioned(beside, vm):
    column = (
        '[[published]]\nname = "Book"\nsource = "A"\nkind = "target"\nvalues = { z_T = "-99.9" }\n\n[deck]\n'
    )
    beside(("[deck]\n", column))
    code, printed, _ = vm("check", "fall")
    assert code == 0
    assert "doubtful: [published] 1 (Book): z_T = -99.9: theory gives -1.22625" in printed


def test_data_for_which_an_event_does_not_happen_are_a_usage_error(beside, vm):
    beside(('TEND = "t_end"\n', ""), ('G    = "g"', 'G    = "g*T/T"'))
    code, _, error = vm(*RUN, "fall", "--set", "T=0.7")
    assert code == 4
    assert "Usage: vm run" in error
    assert "--set: fall: [events] then: at = T is 0.7, but the run of the deck ends at 0.6" in error
    assert not Path("r.json").exists()


def test_data_outside_the_region_of_the_sweep_are_a_usage_error(beside, vm):
    beside(("[deck]\n", "[sweep]\nranges = { g = [1.0, 20.0] }\n\n[deck]\n"))
    code, _, error = vm(*RUN, "--set", "g=30")
    assert code == 4
    assert "--set: fall: g = 30 is outside the region of the case, 1 to 20 m/s2" in error
    code, printed, _ = vm(*RUN, "--set", "g=19")
    assert code == 0, printed
