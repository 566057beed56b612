"""Parameter expressions: arithmetic right, everything else refused."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.deck.expression import evaluate

NAMES = {"k": 2.0, "n": 3, "lambda": 5.0, "word": "text"}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2*3", 7),
        ("-2**2", -4),
        ("2**3**2", 512),
        ("(1.0 + 2.0)/4", 0.75),
        ("&k*k", 4.0),
        ("K*&LAMBDA", 10.0),
        ("1.5d2 + 1.e0", 151.0),
        ("sqrt(16.0) + abs(-n)", 7.0),
        ("atan2(1.0, 1.0)", math.pi / 4),
        ("max(1, n, 2) - min(1, n)", 2),
        ("mod(-7, 3)", -1),
        ("mod(7.5, 2.0)", 1.5),
        ("nint(-2.5) + nint(2.4) + int(2.9)", 1),
        ("sign(3.0, -1.0)", -3.0),
        ("6/3", 2),
        ("1.0/2", 0.5),
        ("2.0**(-1)", 0.5),
    ],
)
def test_values(text: str, value: float) -> None:
    result = evaluate(text, NAMES)
    assert result == pytest.approx(value, rel=1e-15)
    assert type(result) is type(value)


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
def test_arithmetic_is_that_of_double_precision(a: float, b: float) -> None:
    assert evaluate("&a + &b*(&a - &b)", {"a": a, "b": b}) == a + b * (a - b)


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("1/2", r"1/2 is a division of integers with a rest; write 1\.0/2"),
        ("2**(-1)", "negative power"),
        ("kk + 1", "kk: no such parameter; did you mean k"),
        ("sqr(2.0)", "sqr: no such function; did you mean sqrt"),
        ("word + 1", "word: no such parameter"),
        ("1/0", "division by zero"),
        ("1.0/0.0", "division by zero"),
        ("(-8.0)**(1.0/3.0)", "not a finite real"),
        ("sqrt(-1.0)", "math domain error|expected a nonnegative"),
        ("1e300*1e300", "not a finite real"),
        ("exp(1000.0)", "too large"),
        ("9**9**9**9", "too large"),
        ("10**30", "too large"),
        ("2.0**1e9", "too large"),
        ("sqrt(1.0, 2.0)", "number of arguments"),
        ("max()", "number of arguments"),
    ],
)
def test_what_has_no_value_is_refused(text: str, what: str) -> None:
    with pytest.raises(ValueError, match=what):
        evaluate(text, NAMES)


@pytest.mark.parametrize(
    "text",
    [
        "", "1 +", "__import__('os')", "k.real", "(1).real", "[1]", "k if 1 else 2", "k < 2", "1//2", "k and k",
        "lambda x: x", "'a'", "0x10", "1_0", "1j", "True", "sqrt(x=2)", "sqrt(*k)", "1, 2", "max(k for k in k)",
        "k\n+1", "(" * 240 + "1" + ")" * 240, "~1", "a := 1",
    ],
)  # fmt: skip
def test_what_is_not_arithmetic_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"not an expression|no such (parameter|function)"):
        evaluate(text, NAMES)


def test_length_is_limited() -> None:
    with pytest.raises(ValueError, match="500 characters"):
        evaluate("1+" * 300 + "1", NAMES)
    assert evaluate("1" + "+1" * 249, NAMES) == 250


@given(st.text(max_size=60))
def test_any_text_is_a_finite_number_or_a_value_error(text: str) -> None:
    try:
        value = evaluate(text, NAMES)
    except ValueError:
        return
    assert math.isfinite(value)
