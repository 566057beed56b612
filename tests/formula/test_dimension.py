"""Dimensions form a group under multiplication, with rational powers."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from vmharness.formula.dimension import DIMENSIONLESS, FORCE, LENGTH, MASS, TIME, Dimension

exponents = st.fractions(-4, 4, max_denominator=6)
dimensions = st.builds(Dimension, exponents, exponents, exponents, exponents)


@given(dimensions, dimensions, dimensions)
def test_product_is_a_group(a: Dimension, b: Dimension, c: Dimension) -> None:
    assert a * b == b * a
    assert (a * b) * c == a * (b * c)
    assert a * DIMENSIONLESS == a
    assert (a / b) * b == a
    assert a / a == DIMENSIONLESS


@given(dimensions, dimensions, exponents, exponents)
def test_powers(a: Dimension, b: Dimension, m: Fraction, n: Fraction) -> None:
    assert (a * b) ** m == a**m * b**m
    assert a**m * a**n == a ** (m + n)
    assert (a**m) ** n == a ** (m * n)


def test_names() -> None:
    assert str(DIMENSIONLESS) == "dimensionless"
    assert str(FORCE) == "mass-length/time2"
    assert str(DIMENSIONLESS / TIME) == "1/time"
    assert str(MASS / LENGTH ** Fraction(1, 2)) == "mass/length^(1/2)"
