"""What is a formula, and what is refused."""

import pytest

from vmharness.formula import Formula, FormulaError


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("-2**2", -4.0),
        ("2**-1", 0.5),
        ("2^3^2", 512.0),
        ("-2^2*3", -12.0),
        ("8/4/2", 1.0),
        ("8/-4*2", -4.0),
        ("1 - 2 - 3", -4.0),
        ("2 - -3*4", 14.0),
        ("+3 - +2", 1.0),
        (".5e1 + 5. + 1E-1", 10.1),
        ("(1 + 2)*\n\t3", 9.0),
        ("where(1 < 2 < 3, 1, 0)", 1.0),
        ("where(1 < 2 > 3, 1, 0)", 0.0),
        ("where(not 1 < 2 or 2 < 3 and 3 < 2, 1, 0)", 0.0),
        ("where((1 < 2 or 2 < 3) and not 3 < 2, 1, 0)", 1.0),
        ("where(1 == 1 and 1 != 2 and 1 <= 1 and 1 >= 1, 1, 0)", 1.0),
        ("max(1, 5, 3) - min(2, 0, 1)", 5.0),
    ],
)
def test_precedence(text: str, value: float) -> None:
    assert Formula(text).evaluate({}) == value


def test_names() -> None:
    assert Formula("2*pi*r + lambda").names == {"r", "lambda"}
    assert Formula("sum(a*n, n, n0, N) + root(x - b, x, 0, c)").names == {"a", "n0", "N", "b", "c"}
    assert Formula("n + sum(n, n, 1, n)").names == {"n"}


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('id')",
        "().__class__",
        "a.real",
        "a[0]",
        "[1, 2]",
        "{1}",
        "lambda x: x",
        "(lambda: 1)()",
        "f'{a}'",
        "'a'*9",
        "a if b else c",
        "a := 1",
        "a = 1",
        "a; b",
        "a # b",
        "a @ b",
        "a // b",
        "a % b",
        "a & b",
        "a | b",
        "~a",
        "!a",
        "a is b",
        "1_000",
        "0x10",
        "1j",
        "１",
        "ω",
        "a\0b",
        "sqrt(x=1)",
        "sqrt(*a)",
        "sqrt",
        "sqrt()",
        "sqrt()()",
        "eval(a)",
        "open(a)",
        "exec(a)",
        "not",
        "and",
        "a and b",
        "not a",
        "a < b",
        "(a < b) + 1",
        "sin(a < b)",
        "where(a, 1, 2)",
        "where(a < b, a < b, 2)",
        "where(a < b, 1)",
        "(a < b) < c",
        "sum(n, n + 1, 1, 2)",
        "sum(n, pi, 1, 2)",
        "sum(n < 2, n, 1, 2)",
        "min(a)",
        "atan2(a)",
        "sin(a, b)",
        "",
        " ",
        "()",
        "a b",
        "2 3",
        "2 (3)",
        "a +",
        "* a",
        "(a",
        "a)",
        "a,b",
        "1e999",
    ],
)
def test_refused(text: str) -> None:
    with pytest.raises(FormulaError):
        Formula(text)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("2*h + 3g", "`2*h + 3g`, column 7: `3g`: write 3*g"),
        ("sqr(h)", "`sqr(h)`, column 1: `sqr` is not a function; did you mean sqrt?"),
        ("omega(t)", "`omega` is not a function; known: abs, acos"),
        ("1 + sqrt", "column 5: `sqrt` is a function: sqrt(x)"),
        ("atan2(y)", "atan2 takes (y, x), not 1 of them"),
        ("(a + b", "column 7: an operator or `)` is expected, not the end"),
        ("a b", "column 3: an operator is expected, not `b`"),
        ("a + ", "a number, a name or `(` is expected, not the end"),
        ("a.b", "column 2: `.` is not allowed in a formula"),
        ("where(a = b, 1, 2)", "column 9: `=` is not allowed in a formula; write == to compare"),
        ("where(t, 1, 2)", "in `where(t, 1, 2)`: a condition such as a < b is expected, not `t`"),
        ("1 + (a < b)", "in `1 + (a < b)`: a number is expected, not `a < b`"),
        ("sum(n, 2, 1, 3)", "sum: a name is expected second, not `2`"),
    ],
)
def test_messages(text: str, message: str) -> None:
    with pytest.raises(FormulaError) as error:
        Formula(text)
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("(" * 5000, "longer than 2000 characters"),
        ("(" * 150 + "a" + ")" * 150, "nested deeper than 40"),
        ("-" * 300 + "a", "nested deeper than 40"),
        ("where(" + "not " * 300 + "a < b, 1, 2)", "nested deeper than 40"),
        ("a**" * 100 + "a", "nested deeper than 40"),
        ("sqrt(" * 60 + "a" + ")" * 60, "nested deeper than 40"),
        ("+".join("a" * 500), "more than 400 numbers, names and signs"),
    ],
)
def test_size_is_bounded(text: str, message: str) -> None:
    with pytest.raises(FormulaError, match=message):
        Formula(text)


@pytest.mark.parametrize(
    "text",
    [
        "+".join("a" * 200),
        "*".join("a" * 200),
        "a" + "/a" * 199,
        "-" * 39 + "a",
        "(" * 39 + "a" + ")" * 39,
        "where(a > 0, 1, " * 38 + "2" + ")" * 38,
        "a + " * 150 + "(" * 30 + "a" + ")" * 30,
    ],
)
def test_what_is_within_the_bounds_can_be_worked_with(text: str) -> None:
    f = Formula(text)
    one = Formula("1").dimension({})
    assert f.dimension({"a": one}) == one
    assert abs(f.evaluate({"a": 1.0})) >= 1
    assert f.latex()
    assert f.mathml()


def test_formulas_are_equal_by_text_and_can_be_keys() -> None:
    assert Formula("a + b") == Formula("a + b")
    assert len({Formula("a"), Formula("a"), Formula("b")}) == 2
