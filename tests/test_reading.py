"""Reading a history as a published column was read."""

import numpy as np
import pytest

from vmharness.history import History
from vmharness.reading import prints_as, states


def test_states_are_the_last_cycles_not_after_the_nominal_times():
    time = np.arange(0.0, 10.0, 0.7)
    chosen = states(History(time, {}), 2.0)
    np.testing.assert_allclose(time[chosen], [0.0, 1.4, 3.5, 5.6, 7.7])


def test_a_history_that_begins_late_has_no_state_before_it():
    assert states(History(np.array([0.5, 1.2, 2.9]), {}), 1.0).tolist() == [0, 1]


def test_a_cycle_on_the_nominal_time_counts_in_spite_of_round_off():
    time = np.cumsum(np.full(1001, 1e-4)) - 1e-4  # its hundredth sample misses 0.01 by round-off
    assert states(History(time, {}), 0.01).tolist() == list(range(0, 1001, 100))


@pytest.mark.parametrize("interval", [1e-12, 1e-300, 5e-324, 0.1])
def test_of_an_interval_below_the_steps_every_sample_is_a_state(interval):
    assert states(History(np.linspace(0.0, 1.0, 11), {}), interval).tolist() == list(range(11))


def test_states_need_no_list_of_nominal_times_where_steps_differ():
    time = np.concatenate([np.linspace(0.0, 1e-13, 5), [1.0, 1e6]])
    assert states(History(time, {}), 1e-12).tolist() == [0, 4, 5, 6]


def test_printed_digits_decide():
    assert prints_as(-1.000469, "-1.0005")
    assert not prints_as(-1.000449, "-1.0005")
    assert prints_as(193.0986, "193.10")
    assert not prints_as(193.0903, "193.10")
    assert prints_as(0.0999993, "0.10000")
