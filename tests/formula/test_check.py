"""Units are checked through every operation."""

from fractions import Fraction

import pytest

from vmharness.formula import Dimension, Formula, FormulaError, Unit

KNOWN = {
    name: Unit(unit).dimension
    for name, unit in {
        "m": "kg", "k": "N/m", "g": "m/s2", "h": "m", "t": "s", "v": "m/s", "F": "N", "E": "Pa", "rho": "kg/m3",
        "omega": "rad/s", "x": "1", "nu": "1",
    }.items()
}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("sqrt(2*h/g)", "s"),
        ("cbrt(h**3)", "m"),
        ("m*g*h", "J"),
        ("sqrt(k/m)", "1/s"),
        ("sqrt(E/rho)", "m/s"),
        ("h^(3/2)", "m^(3/2)"),
        ("h**0.5*h**-.5", "1"),
        ("(h*h)**-2", "m^-4"),
        ("x**nu", "1"),
        ("2**(omega*t)", "1"),
        ("h*sin(omega*t) - g*t^2/2", "m"),
        ("atan2(v, g*t)", "1"),
        ("abs(-v)", "m/s"),
        ("sign(F)", "1"),
        ("min(h, v*t, 0)", "m"),
        ("max(0, F)", "N"),
        ("where(t < t + 1*t and not h == 0, 0, F)", "N"),
        ("where(x < 1, h, where(x < 2, 0, v*t))", "m"),
        ("0 + h", "m"),
        ("h - 0.0", "m"),
        ("0*h", "m"),
        ("-0 + F", "N"),
        ("sum(h/n**2, n, 1, 10)", "m"),
        ("root(v*s - h, s, 0, t)", "s"),
        ("root(a*tan(a) - 1, a, 0, pi/3)", "1"),
        ("ellipk(x)*besselj(0, omega*t)", "1"),
        ("pi*h", "m"),
        ("0", "1"),
    ],
)
def test_dimension(text: str, unit: str) -> None:
    assert Formula(text).dimension(KNOWN) == Unit(unit).dimension


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("h + t", "in `h + t`: length + time: both sides of + must have the same unit"),
        ("2*(h*g - v)", "in `h*g - v`: length2/time2 - length/time: both sides of - must have the same unit"),
        ("h + 1", "in `h + 1`: length + dimensionless: both sides of +"),
        ("sin(t)", "in `sin(t)`: the argument of sin must be dimensionless, `t` is time"),
        ("exp(-omega)", "`-omega` is 1/time"),
        ("h**x", "in `h**x`: `h` is length, so the exponent must be a number such as 3/2"),
        ("h**1e99999", ""),
        ("2**h", "in `2**h`: the exponent must be dimensionless, `h` is length"),
        ("where(t < h, 1, 2)", "in `t < h`: time, length: what is compared must have the same unit"),
        ("where(t > 0, h, t)", "in `where(t > 0, h, t)`: length, time: both branches of where"),
        ("min(h, 1)", "all arguments of min"),
        ("atan2(h, t)", "both arguments of atan2"),
        ("sum(n, n, 1, h)", "a bound of sum must be dimensionless, `h` is length"),
        ("sum(n*h + t, n, 1, 3)", "in `n*h + t`"),
        ("root(v*s - t, s, 0, t)", "in `v*s - t`: length - time"),
        ("root(s, s, h, t)", "both bounds of root"),
        ("besselj(h, 1)", "the argument of besselj"),
        ("omga*t", "`omga` is not known; did you mean omega?"),
    ],
)
def test_messages(text: str, message: str) -> None:
    with pytest.raises(FormulaError) as error:
        Formula(text).dimension(KNOWN)
    assert message in str(error.value)


def test_a_bound_variable_is_unknown_outside() -> None:
    with pytest.raises(FormulaError, match="`n` is not known"):
        Formula("sum(n, n, 1, 3) + n").dimension({})


def test_a_bound_variable_hides_a_quantity_inside() -> None:
    assert Formula("sum(1/t, t, 1, 3)").dimension(KNOWN) == Dimension()


def test_roots_divide_exponents() -> None:
    assert Formula("sqrt(sqrt(h))").dimension(KNOWN) == Dimension(length=Fraction(1, 4))
    assert Formula("cbrt(sqrt(h))").dimension(KNOWN) == Dimension(length=Fraction(1, 6))
