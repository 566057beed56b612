"""Digits and orders that the last bits of numbers cannot move."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.report.number import decimals, positional, share, short, significant
from vmharness.round_off import largest, ordered, rounded, smallest

SIXTHS = st.lists(st.integers(-60, 60).map(lambda n: n / 6.0), min_size=1)
LAST_BITS = st.floats(-1e-13, 1e-13)


@pytest.mark.parametrize("value", [0.125, 0.0125, 3.850425, 2.5e-7, 1234.565])
@pytest.mark.parametrize("printed", [significant, short, decimals, share, lambda value: positional(value, 2)])
def test_a_number_half_way_prints_alike_with_other_last_bits(value, printed):
    assert printed(value * (1.0 + 1e-13)) == printed(value) == printed(value * (1.0 - 1e-13))


def test_rounding_keeps_what_is_no_number():
    assert math.isinf(rounded(math.inf))
    assert math.isnan(rounded(math.nan))
    assert rounded(0.0) == 0.0


@given(SIXTHS, st.data())
def test_last_bits_do_not_change_an_order(values, data):
    other = [value * (1.0 + data.draw(LAST_BITS)) for value in values]
    places = range(len(values))
    expected = sorted(places, key=lambda i: values[i])  # equal ones as they come
    assert ordered(places, values.__getitem__) == ordered(places, other.__getitem__) == expected


@given(SIXTHS)
def test_the_first_of_equals_is_chosen(values):
    doubled = [*values, *(value * (1.0 - 1e-13) for value in values)]
    places = range(len(doubled))
    assert smallest(places, doubled.__getitem__) == values.index(min(values))
    assert largest(places, doubled.__getitem__) == values.index(max(values))


def test_real_differences_count():
    assert ordered("abc", {"a": 1.00001, "b": 1.0, "c": -1.0}.__getitem__) == ["c", "b", "a"]


def test_infinite_values_agree_with_themselves_alone():
    of = {"a": 1e300, "b": math.inf, "c": math.inf, "d": -math.inf}
    assert ordered("abcd", of.__getitem__) == ["d", "a", "b", "c"]
    assert largest("abcd", of.__getitem__) == "b"


def test_near_zero_only_an_absolute_difference_tells_what_is_round_off():
    of = {"a": 1e-17, "b": 0.0, "c": 1.0}
    assert ordered("abc", of.__getitem__) == ["b", "a", "c"]
    assert ordered("abc", of.__getitem__, least=1e-12) == ["a", "b", "c"]
