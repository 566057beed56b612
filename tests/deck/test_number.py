"""Fortran's numbers, and what is none."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.deck.number import to_integer, to_real


@given(st.floats(allow_nan=False, allow_infinity=False), st.sampled_from("eEdD"))
def test_any_double_is_read_back_exactly_with_any_exponent_letter(value: float, letter: str) -> None:
    mantissa, _, exponent = f"{value:.17e}".partition("e")
    assert to_real(f"{mantissa}{letter}{exponent}") == float(f"{value:.17e}")
    assert to_real(f"{mantissa}{exponent}") == float(f"{value:.17e}")  # without a letter the sign separates


@pytest.mark.parametrize(
    "text", ["", "x", "1.0.0", "1 0", "inf", "nan", "1_0", "0x10", "--1", "1e", "1+", ".", "e5", "٣", "1,0"]
)
def test_what_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="not a number"):
        to_real(text)
    with pytest.raises(ValueError, match="not a number"):
        to_integer(text)


def test_numbers_too_large_are_refused() -> None:
    with pytest.raises(ValueError, match="too large for double"):
        to_real("1e999")
    with pytest.raises(ValueError, match="too large for an integer"):
        to_integer("99999999999999999999")


@given(st.integers(-(2**53), 2**53))
def test_integers_may_be_written_as_reals(value: int) -> None:
    assert to_integer(str(value)) == to_integer(f"{value}.") == to_integer(f"{value}.0e0") == value


def test_an_integer_has_no_fraction() -> None:
    with pytest.raises(ValueError, match="not an integer"):
        to_integer("2.5")
