"""Values of formulas, on numbers and on arrays."""

import math

import numpy as np
import pytest
from scipy import special

from vmharness.formula import Formula, FormulaError


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("sqrt(2)", math.sqrt(2)),
        ("cbrt(-27)", -3.0),
        ("exp(1)", math.e),
        ("log(2)", math.log(2)),
        ("log10(1000)", 3.0),
        ("sin(1)", math.sin(1)),
        ("cos(1)", math.cos(1)),
        ("tan(1)", math.tan(1)),
        ("asin(0.3)", math.asin(0.3)),
        ("acos(0.3)", math.acos(0.3)),
        ("atan(2)", math.atan(2)),
        ("atan2(1, -1)", 3 * math.pi / 4),
        ("sinh(1)", math.sinh(1)),
        ("cosh(1)", math.cosh(1)),
        ("tanh(1)", math.tanh(1)),
        ("abs(-2)", 2.0),
        ("sign(-3) + sign(0) + 5*sign(2)", 4.0),
        ("pi", math.pi),
        ("ellipk(0.5)", 1.8540746773013719),
        ("besselj(0, 2.404825557695773)", 0.0),
        ("0**0", 1.0),
    ],
)
def test_functions(text: str, value: float) -> None:
    result = Formula(text).evaluate({})
    assert isinstance(result, float)
    assert result == pytest.approx(value, rel=1e-14, abs=1e-15)


def test_large_pendulum_of_vm91() -> None:
    period = Formula("4*sqrt(L/g)*ellipk(sin(theta0/2)**2)")
    assert period.evaluate({"L": 1.0, "g": 9.81, "theta0": math.pi / 2}) == pytest.approx(
        2.36784195, rel=1e-8
    )


def test_arrays_broadcast() -> None:
    x, y = np.linspace(0, 1, 4), np.linspace(1, 2, 3)[:, None]
    value = Formula("a*x**2 + y").evaluate({"a": 2, "x": x, "y": y, "unused": np.zeros(17)})
    assert value.shape == (3, 4)
    np.testing.assert_allclose(value, 2 * x**2 + y, rtol=1e-15)


def test_a_constant_over_an_array_has_its_shape() -> None:
    t = np.linspace(0, 1, 5)
    np.testing.assert_array_equal(Formula("where(t < 9, 2, t)").evaluate({"t": t}), np.full(5, 2.0))
    np.testing.assert_array_equal(Formula("where(t < 0.5, 0, 1)").evaluate({"t": t}), [0, 0, 1, 1, 1])


def test_result_is_not_a_view_of_what_was_given() -> None:
    t = np.ones(3)
    Formula("t").evaluate({"t": t})[:] = 7
    np.testing.assert_array_equal(t, 1.0)


def test_empty_arrays() -> None:
    assert Formula("sum(sqrt(t)/n, n, 1, 3) + 1/t").evaluate({"t": np.zeros(0)}).shape == (0,)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("where(x > 0, log(x), -1)", lambda x: math.log(x) if x > 0 else -1),
        ("where(x != 0, sin(x)/x, 1)", lambda x: math.sin(x) / x if x else 1),
        (
            "where(x < 0, sqrt(-x), where(x > 0, 1/x, 0))",
            lambda x: math.sqrt(-x) if x < 0 else 1 / x if x else 0,
        ),
        ("where(x > 0 and log(x) > 0, 1, 0)", lambda x: x > 1),
        ("where(x <= 0 or log(x) > 0, 1, 0)", lambda x: x <= 0 or x > 1),
        ("where(not (x <= 0 or log(x) > 0), 1, 0)", lambda x: not (x <= 0 or x > 1)),
        ("where(-1 <= x <= 1, asin(x), where(x > 1, sum(x**-n, n, 1, 5), root(s - x, s, -9, 0)))", None),
    ],
)
def test_a_branch_not_taken_may_be_outside_its_domain(text: str, expected: object) -> None:
    x = np.array([-2.0, -1.0, 0.0, 0.5, 1.0, 3.0])
    values = Formula(text).evaluate({"x": x})
    one_by_one = [Formula(text).evaluate({"x": each}) for each in x]
    np.testing.assert_allclose(values, one_by_one, rtol=1e-14)
    if callable(expected):
        np.testing.assert_allclose(values, [expected(each) for each in x], rtol=1e-14)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1 + a/(b - 2)", "in `a/(b - 2)`: division by zero"),
        ("(b - 2)**-1", "in `(b - 2)**(-1)`: division by zero"),
        ("(-b)**0.5", "a negative number to a fractional power"),
        ("sqrt(1 - b)", "in `sqrt(1 - b)`: sqrt(x) needs x >= 0, and gets -1"),
        ("log(a - a)", "log(x) needs x > 0, and gets 0"),
        ("asin(b)", "asin(x) needs -1 <= x <= 1, and gets 2"),
        ("acos(-b)", "and gets -2"),
        ("ellipk(1)", "ellipk(m) needs m < 1, and gets 1"),
        ("besselj(0.5, -a)", "besselj(n, x) needs x >= 0, or n whole, and gets -1"),
        ("exp(1000)", "in `exp(1000)`: overflow"),
        ("9**9**9", "overflow"),
        ("1e308*10", "overflow"),
        ("1e308 + 1e308", "overflow"),
        ("-1e308 - 1e308", "overflow"),
        ("1/1e-320", "overflow"),
        ("c + a", "`c` has no value; known: a, b"),
        ("sum(n, n, 1, 1e9)", "1000000000 terms at 1 points are too many"),
        ("sum(sum(n*k, k, 1, 1e5), n, 1, 1e5)", "are too many"),
        ("sum(sum(sum(n*k*j, j, 1, 1e3), k, 1, 1e3), n, 1, 1e3)", "are too many"),
        ("root(sum(root(y - n - x, y, 0, 2e6), n, 1, 10001), x, 0, 1)", "too many points"),
        ("root(root(root(x + y + z, x, -99, 99), y, -20, 20), z, -9, 9)", "the evaluation takes too long"),
        ("sum(sum(besselj(n, k), k, 1, 1e3), n, 1, 1e3)", "the evaluation takes too long"),
        ("sum(sum(sum(sum(1, i, 1, 100), j, 1, 100), k, 1, 100), n, 1, 100)", "are too many"),
        ("sum(n, n, 1, 2.5)", "a bound is 2.5: one whole number is expected"),
        ("sum(1/(n - 3), n, 1, 5)", "in `1/(n - 3)`: division by zero"),
        ("root(x**2 + 1, x, -1, 1)", "in `root(x**2 + 1, x, -1, 1)`: no change of sign between the bounds"),
        ("root(x, x, 1, -1)", "the lower bound is not below the upper"),
        ("root(tan(x), x, 1, 2)", "the sign changes through a pole"),
    ],
)
def test_messages(text: str, message: str) -> None:
    with pytest.raises(FormulaError) as error:
        Formula(text).evaluate({"a": 1.0, "b": 2.0})
    assert message in str(error.value)


def test_faults_in_arrays_name_the_first() -> None:
    with pytest.raises(FormulaError, match="needs x >= 0, and gets -3"):
        Formula("sqrt(t)").evaluate({"t": np.array([1.0, -3.0, -5.0])})
    with pytest.raises(FormulaError, match="division by zero"):
        Formula("1/t").evaluate({"t": np.array([1.0, 0.0])})


@pytest.mark.parametrize("bad", [math.nan, math.inf, np.array([0.0, math.nan])])
def test_values_given_must_be_finite(bad: object) -> None:
    with pytest.raises(FormulaError, match="`a` has a value that is not finite"):
        Formula("where(a < 1, 0, 1)").evaluate({"a": bad})


def test_shapes_that_do_not_go_together() -> None:
    with pytest.raises(FormulaError, match=r"do not go together: x \(3,\), y \(4,\)"):
        Formula("x + y").evaluate({"x": np.zeros(3), "y": np.zeros(4)})


def test_sums() -> None:
    assert Formula("sum(n**2, n, 1, 10)").evaluate({}) == 385.0
    assert Formula("sum(n, n, 3, 2)").evaluate({}) == 0.0
    assert Formula("sum(c, n, -1, 1)").evaluate({"c": 2.0}) == 6.0
    assert Formula("sum(sum(where(k <= n, n*k, 0), k, 1, 3), n, 1, 3)").evaluate({}) == 25.0
    assert Formula("sum(1/n**2, n, 1, 1000000)").evaluate({}) == pytest.approx(
        math.pi**2 / 6 - 1e-6 + 5e-13, rel=1e-14
    )


def test_sum_in_chunks_over_an_array() -> None:
    x = np.linspace(0.1, 3.0, 3001)  # 3001 points x 2000 terms: several chunks
    saw = Formula("sum(sin(n*x)/n, n, 1, N)")
    exact = sum(np.sin(n * x) / n for n in range(1, 2001))
    np.testing.assert_allclose(saw.evaluate({"x": x, "N": 2000}), exact, rtol=0, atol=1e-12)
    np.testing.assert_allclose(
        saw.evaluate({"x": x[1:-1], "N": 2000}), (math.pi - x[1:-1]) / 2, rtol=0, atol=0.02
    )


def test_roots() -> None:
    assert Formula("root(x**2 - 2, x, 0, 2)").evaluate({}) == pytest.approx(math.sqrt(2), rel=4e-16)
    assert Formula("root(besselj(0, x), x, 2, 3)").evaluate({}) == pytest.approx(
        special.jn_zeros(0, 1)[0], rel=1e-15
    )
    assert Formula("root(x, x, -1, 3)").evaluate({}) == pytest.approx(0, abs=1e-29)
    assert Formula("root(x - 1, x, 1, 3)").evaluate({}) == 1.0
    assert Formula("root(x - 3, x, 1, 3)").evaluate({}) == 3.0
    a = np.array([1.0, 4.0, 9.0])
    np.testing.assert_allclose(
        Formula("root(x**2 - a, x, 0, a + 1)").evaluate({"a": a}), [1, 2, 3], rtol=1e-15
    )


def test_cantilever_frequencies_by_root() -> None:
    # cosh(b) cos(b) = -1: b = 1.875104068711961, 4.694091132974175
    b = Formula("root(cosh(b)*cos(b) + 1, b, low, high)")
    assert b.evaluate({"low": 1, "high": 3}) == pytest.approx(1.875104068711961, rel=1e-15)
    assert b.evaluate({"low": 3, "high": 6}) == pytest.approx(4.694091132974175, rel=1e-15)
