"""Events and published states are within the run."""

import pytest

from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.review.run_length import intervals, outside_run

STATES = """[[published]]
name = "Code"
source = "A manual"
kind = "computed"
values = {{ z_T = "-1.226" }}
interval = {}

[deck]
"""


def reviewed(review, folder):
    case = read(folder)
    return review(case, read_deck(case))


@pytest.mark.parametrize("end", ["0.6", "0.5"])
def test_an_event_up_to_the_end_is_measured(fall, end):
    assert reviewed(outside_run, fall(("RTEND          0.6", f"RTEND          {end}"))) == []


def test_an_event_after_the_end_is_an_error(fall):
    (sentence,) = reviewed(outside_run, fall(("RTEND          0.6", "RTEND          0.4")))
    assert sentence == "[events] then: at = T is 0.5, but the run of the deck ends at 0.4"


def test_a_result_whose_time_is_after_the_end_is_an_error(fall):
    level = ('at = "T"', 'crossing_of = "z", level = "z_T", direction = "down"')
    time = (
        'channel   = "z"\ntarget    = "z_T"\nunit      = "m"',
        'channel   = "time"\ntarget    = "T"\nunit      = "s"',
    )
    (sentence,) = reviewed(outside_run, fall(level, time, ("RTEND          0.6", "RTEND          0.4")))
    assert sentence == "[results] 1: z_T: target = T is 0.5, but the run of the deck ends at 0.4"


def test_an_event_at_the_very_start_reads_the_input(fall):
    (sentence,) = reviewed(outside_run, fall(('at = "T"', 'at = "1e-8*T"')))
    assert (
        sentence
        == "[events] then: at = 1e-8*T is 5e-09: at the start of the run all values are those of the deck"
    )


@pytest.mark.parametrize("interval", [1e-10, 1e-300, 0.7, 1e300])
def test_an_interval_that_no_run_has_is_an_error(fall, interval):
    (sentence,) = reviewed(intervals, fall(("[deck]\n", STATES.format(interval))))
    assert sentence.startswith(
        f"[published] 1: interval = {interval:g}: the run of 0.6 s has 1 to 1e+06 states"
    )


@pytest.mark.parametrize("interval", [1e-6, 0.01, 0.6])
def test_an_interval_of_states_is_within_the_run(fall, interval):
    assert reviewed(intervals, fall(("[deck]\n", STATES.format(interval)))) == []
