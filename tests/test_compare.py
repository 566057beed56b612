"""The gate: what passes, what fails, what cannot be judged."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.compare import Tolerance, Verdict, compare, worst

number = st.floats(1e-6, 1e6) | st.floats(-1e6, -1e-6)


@given(number, st.floats(-2.0, 2.0))
def test_the_verdict_is_the_inequality(target, share):
    tolerance = Tolerance(relative=1e-3, absolute=1e-9)
    value = target + share * tolerance.allowed(target)
    expected = abs(value - target) <= 1e-9 + 1e-3 * abs(target)
    row = compare(target, value, tolerance)
    assert (row.verdict is Verdict.PASS) == expected
    assert row.share == pytest.approx(abs(share), rel=1e-6, abs=1e-6)


def test_errors_are_signed_as_the_manual_prints_them():
    # VM-061: 0.10000 for 0.10044 is -0.44 %, -1.5505 for -1.5507 is -0.01 %.
    assert compare(0.10044, 0.1, Tolerance(1.0)).error_percent == pytest.approx(-0.438, abs=1e-3)
    assert compare(-1.5507, -1.5505, Tolerance(1.0)).error_percent == pytest.approx(-0.0129, abs=1e-4)
    assert compare(-1.0, -1.0005, Tolerance(1.0)).error_percent == pytest.approx(0.05)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_value_that_is_no_number_fails(value):
    row = compare(1.0, value, Tolerance(1e9, 1e9))
    assert row.verdict is Verdict.FAIL
    assert row.error_percent is row.share or row.share is None
    assert "computed value" in row.reason


def test_a_target_that_is_no_number_cannot_be_judged():
    assert compare(math.nan, 1.0, Tolerance(1.0)).verdict is Verdict.ERROR


@pytest.mark.parametrize(("target", "scale"), [(0.0, 0.0), (0.0, 5.0), (1e-9, 1.0)])
def test_near_zero_only_an_absolute_tolerance_judges(target, scale):
    assert compare(target, target, Tolerance(relative=0.5), scale).verdict is Verdict.ERROR
    assert compare(target, 1e-3, Tolerance(absolute=1e-2), scale).verdict is Verdict.PASS
    assert compare(target, 1e-1, Tolerance(absolute=1e-2), scale).verdict is Verdict.FAIL


def test_a_failure_says_both_numbers_and_what_was_allowed():
    reason = compare(2.0, 2.1, Tolerance(0.01)).reason
    assert reason == "2.1 differs from 2 by 0.1, allowed 0.02"


def test_nothing_judged_is_an_error_and_the_worst_is_said():
    assert worst([]) is Verdict.ERROR
    assert worst([Verdict.PASS, Verdict.FAIL]) is Verdict.FAIL
    assert worst([Verdict.FAIL, Verdict.ERROR, Verdict.PASS]) is Verdict.ERROR
    assert worst([Verdict.PASS]) is Verdict.PASS
