"""Properties over random formulas: what is written is read back, and means what Python says it means."""

import math
import xml.etree.ElementTree as ET

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vmharness.formula import Formula, FormulaError
from vmharness.formula.parse import parse
from vmharness.formula.text import write
from vmharness.formula.tree import Binary, Bound, Call, Comparison, Logic, Name, Negative, Node, Number

NAMES = ("a", "b2", "t_impact", "omega")
values = st.fixed_dictionaries({name: st.integers(-64, 64).map(lambda n: n / 8) for name in NAMES})
leaves = st.sampled_from([Number("2"), Number("0.125"), Number("3e0"), *map(Name, NAMES)])


def operations(operators: str) -> st.SearchStrategy[Node]:
    """Trees of operators of one character each, `^` for the power, and of minus signs."""

    def grow(inner: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
        signs = st.sampled_from([sign.replace("^", "**") for sign in operators])
        return st.builds(Negative, inner) | st.builds(Binary, signs, inner, inner)

    return st.recursive(leaves, grow, max_leaves=10)


ONE = ("sqrt", "cbrt", "exp", "log", "log10", "sin", "asin", "abs", "sign", "ellipk")
TWO = ("atan2", "min", "max", "besselj")


@st.composite
def numbers(draw: st.DrawFn, depth: int = 4) -> Node:
    """Trees of every kind whose value is a number."""
    kind = (
        draw(st.sampled_from(["leaf", "negative", "binary", "one", "two", "where", "bound"]))
        if depth
        else "leaf"
    )
    inner = numbers(depth - 1)
    match kind:
        case "leaf":
            return draw(leaves)
        case "negative":
            return Negative(draw(inner))
        case "binary":
            return Binary(draw(st.sampled_from(["+", "-", "*", "/", "**"])), draw(inner), draw(inner))
        case "one":
            return Call(draw(st.sampled_from(ONE)), (draw(inner),))
        case "two":
            return Call(draw(st.sampled_from(TWO)), (draw(inner), draw(inner)))
        case "where":
            return Call("where", (draw(conditions(depth - 1)), draw(inner), draw(inner)))
    variable = draw(st.sampled_from(["n", "a"]))
    return Bound(draw(st.sampled_from(["sum", "root"])), draw(inner), variable, draw(inner), draw(inner))


@st.composite
def conditions(draw: st.DrawFn, depth: int) -> Node:
    """Trees that are true or false."""
    word = draw(st.sampled_from(["", "not", "and", "or"])) if depth else ""
    if word:
        count = 1 if word == "not" else draw(st.integers(2, 3))
        return Logic(word, tuple(draw(conditions(depth - 1)) for _ in range(count)))
    signs = draw(st.lists(st.sampled_from(["<", "<=", ">", ">=", "==", "!="]), min_size=1, max_size=2))
    return Comparison(tuple(signs), tuple(draw(numbers(max(0, depth - 2))) for _ in range(len(signs) + 1)))


def short(tree: Node) -> bool:
    """Whether the text is within the bounds of a formula, with room for another."""
    return len(write(tree)) < 500


trees = numbers().filter(short)


@given(trees)
def test_written_formula_is_read_as_the_same_tree(tree: Node) -> None:
    assert parse(write(tree)) == tree


@given(operations("+-*/"), values)
def test_arithmetic_is_python_s(tree: Node, quantities: dict[str, float]) -> None:
    text = write(tree)
    try:
        expected = eval(text, {}, quantities)
    except ZeroDivisionError:
        with pytest.raises(FormulaError, match="division by zero"):
            Formula(text).evaluate(quantities)
    else:
        assert Formula(text).evaluate(quantities) == expected


@given(
    operations("*/^"), st.fixed_dictionaries({name: st.sampled_from([0.5, 1.0, 1.5, 2.0]) for name in NAMES})
)
def test_powers_are_python_s(tree: Node, quantities: dict[str, float]) -> None:
    text = write(tree)
    try:
        expected = eval(text, {}, quantities)
    except (ZeroDivisionError, OverflowError):
        with pytest.raises(FormulaError):
            Formula(text).evaluate(quantities)
        return
    if isinstance(expected, complex):
        with pytest.raises(FormulaError, match="a negative number to a fractional power"):
            Formula(text).evaluate(quantities)
        return
    assume(math.isfinite(expected) and abs(expected) > 1e-250)
    assert Formula(text).evaluate(quantities) == pytest.approx(expected, rel=1e-9)


@given(trees)
def test_mathml_is_well_formed_and_complete(tree: Node) -> None:
    children = {"mfrac": 2, "msup": 2, "msub": 2, "mroot": 2, "mover": 2, "munderover": 3, "mtr": 2}
    root = ET.fromstring(f"<math>{Formula(write(tree)).mathml()}</math>")
    for element in root.iter():
        if element.tag in children:
            assert len(element) == children[element.tag], element.tag
        if element.tag in ("mi", "mn", "mo", "mtext"):
            assert element.text
            assert len(element) == 0


@given(trees)
def test_latex_is_balanced_and_survives_markdown(tree: Node) -> None:
    latex = Formula(write(tree)).latex()
    assert latex.count("{") == latex.count("}")
    assert latex.count(r"\left") - latex.count(r"\leftarrow") == latex.count(r"\right")
    assert latex.count(r"\begin{cases}") == latex.count(r"\end{cases}")
    # Markdown eats a backslash before punctuation, `<` may open a tag, `*` emphasis, `$` ends the formula.
    for at in (i for i, character in enumerate(latex) if character == "\\"):
        assert latex[at + 1].isalpha()
    assert not set("<>*$|") & set(latex)


@given(trees, trees)
def test_names_are_free_names(tree: Node, other: Node) -> None:
    assert (
        Formula(f"({write(tree)}) + ({write(other)})").names
        == Formula(write(tree)).names | Formula(write(other)).names
    )
