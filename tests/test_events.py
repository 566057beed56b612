"""Events between samples, against functions whose events are known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.events import EventError, crossings, ends, find, minima, onsets

phase = st.floats(0.0, 1.0, exclude_max=True)


def sampled(f, dt, offset=0.0, end=1.0):
    time = np.arange(0.0, end, dt) + offset * dt
    return time, f(time)


def push(start):
    """A contact force that begins at `start`: zero, then k sin."""
    return lambda t: np.where(t > start, 100.0 * np.sin(6.0 * np.maximum(t - start, 0.0)), 0.0)


@given(phase)
def test_onset_is_found_far_inside_a_step_whatever_its_phase(offset):
    time, force = sampled(push(0.5), 1e-3, offset, end=0.8)
    (t,) = onsets(time, force)
    assert abs(t - 0.5) < 6.0**2 * 1e-9  # omega^2 dt^3
    first = time[np.flatnonzero(force)[0]]
    assert first >= t  # never later than the first sample with force


@given(phase)
def test_end_is_the_mirror_of_onset(offset):
    time, force = sampled(push(0.5), 1e-3, offset, end=0.8)
    (t,) = ends(-time[::-1], force[::-1])
    assert -t == pytest.approx(onsets(time, force)[0], rel=1e-14)
    assert -t == pytest.approx(0.5, abs=6.0**2 * 1e-9)


def test_end_without_a_root_in_its_step_says_so():
    with pytest.raises(EventError, match="ends between 4 and 5, but cannot be located"):
        ends(np.arange(7.0), np.array([0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0]))


def test_onset_error_falls_with_the_third_power_of_the_step():
    errors = [
        max(abs(onsets(*sampled(push(0.5), dt, p, end=0.8))[0] - 0.5) for p in np.linspace(0.0, 0.95, 20))
        for dt in (4e-3, 2e-3, 1e-3)
    ]
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 3.0, atol=0.2)


def test_onset_with_two_samples_left_uses_the_line():
    assert onsets(np.arange(4.0), np.array([0.0, 0.0, 1.0, 3.0])) == [1.5]


@pytest.mark.parametrize("start", [7, 7.25, 7.999])
def test_onset_just_at_a_sample_is_found(start):
    time = np.arange(15) * 1e-4
    (t,) = onsets(time, np.where(time > start * 1e-4, 5.0 * (time - start * 1e-4), 0.0))
    assert t == pytest.approx(start * 1e-4, abs=1e-10)


def test_onset_without_a_kink_is_the_double_root():
    time = np.arange(12.0)
    (t,) = onsets(time, np.where(time > 4.3, (time - 4.3) ** 2, 0.0))
    assert t == pytest.approx(4.3, abs=1e-3)


def test_a_contact_too_short_for_every_second_sample_is_located_all_the_same():
    time = np.arange(20.0)
    force = np.where((time > 7.5) & (time < 10.6), np.sin((time - 7.5) * np.pi / 3.1), 0.0)
    event = find(onsets, time, force, times=1, pick=1)
    assert event.time == pytest.approx(7.5, abs=0.2)
    assert event.uncertainty >= 0.2


def test_onset_that_does_not_point_back_into_its_step_is_refused():
    with pytest.raises(EventError, match="begins between 1 and 2, but cannot be located"):
        onsets(np.arange(5.0), np.array([0.0, 0.0, 5.0, 4.9, 4.8]))


@given(phase)
def test_crossing_by_hermite_errs_by_the_fourth_order(offset):
    time, y = sampled(np.cos, 1e-2, offset, end=3.0)
    (t,) = crossings(time, y, 0.25, "down")
    assert abs(t - np.arccos(0.25)) < 1e-7
    assert crossings(time, y, 0.25, "up") == []


def test_crossing_exactly_at_a_sample_is_that_sample():
    time = np.linspace(0.0, 2.0, 5)
    assert crossings(time, 1.0 - time, 0.0, "down") == [1.0]


@given(phase)
def test_minimum_by_parabola_errs_by_the_third_order(offset):
    time, y = sampled(lambda t: np.sin(t + 0.3 * t**2), 1e-2, offset, end=4.0)
    (t, *_) = minima(time, y)
    exact = (-1.0 + np.sqrt(1.0 + 4.0 * 0.3 * 1.5 * np.pi)) / 0.6
    assert abs(t - exact) < 1e-4


def test_minimum_at_the_end_of_the_run_has_not_happened():
    time = np.linspace(0.0, 1.0, 100)
    with pytest.raises(EventError, match="did not happen within the run"):
        find(minima, time, -time, times=1, pick=1)


def test_ripple_far_below_the_range_makes_no_minima_of_its_own():
    time = np.linspace(0.0, 2.0 * np.pi, 4001)
    rough = np.cos(time) + 1e-5 * np.cos(900.0 * time)
    assert len(minima(time, rough)) == 1


def test_as_often_as_declared_and_the_one_that_is_meant():
    time, y = sampled(np.cos, 1e-3, end=20.0)
    down = lambda t, v: crossings(t, v, 0.0, "down")  # noqa: E731
    second = find(down, time, y, times=3, pick=2)
    assert second.time == pytest.approx(2.5 * np.pi, abs=1e-9)
    with pytest.raises(
        EventError, match=r"happened 3 times, at 1.570796, 7.853982, 14.13717 .*; the case declares 1"
    ):
        find(down, time, y, times=1, pick=1)


@pytest.mark.parametrize("dt", [1e-2, 3e-3, 1e-3])
def test_uncertainty_covers_the_error(dt):
    for offset in np.linspace(0.0, 0.9, 10):
        event = find(onsets, *sampled(push(0.5), dt, offset, end=0.8), times=1, pick=1)
        assert abs(event.time - 0.5) <= event.uncertainty


def test_samples_that_are_not_finite_are_refused():
    with pytest.raises(EventError, match="not finite"):
        find(onsets, np.arange(3.0), np.array([0.0, np.nan, 1.0]), times=1, pick=1)


def test_a_crossing_in_a_step_whose_powers_overflow_is_told():
    time = np.array([0.0, 1e150, 2e150, 3e150])
    with pytest.raises(EventError, match="cannot be located within a step of 1e\\+150"):
        find(lambda t, y: crossings(t, y, 0.5, "up"), time, np.array([0.0, 0.0, 1.0, 2.0]), 1, 1)


def test_a_minimum_whose_curvature_underflows_is_its_lowest_sample():
    time = 1e200 * np.arange(5.0)
    assert minima(time, 1e-200 * np.array([2.0, 1.5, 1.0, 1.5, 2.0])) == [2e200]
