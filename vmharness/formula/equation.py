"""An equation of the report: symbol = formula = formula with values = value unit."""

from collections.abc import Mapping

from vmharness.formula import latex, mathml
from vmharness.formula.formula import Formula
from vmharness.formula.notation import Notation
from vmharness.formula.tree import Name
from vmharness.formula.typeset import number, replaced, terms
from vmharness.formula.unit import Unit
from vmharness.formula.unit_typeset import unit_in

NOTATIONS: Mapping[str, Notation] = {"latex": latex, "mathml": mathml}

LONG = 150  # characters of a formula


def equation(
    name: str,
    formula: Formula,
    value: str = "",
    unit: Unit | None = None,
    *,
    values: Mapping[str, str] | None = None,
    symbols: Mapping[str, str] | None = None,
    notation: str = "latex",
) -> str:
    r"""One line of theory, as LaTeX without its dollars or as a whole <math> element.

    `value` is the text of the result, `values` those of the names, for a step with numbers in their places.
    A step that repeats the one before it is left out, and the values of a formula too long to stand on a line twice.

    >>> print(equation("t_1", Formula("sqrt(2*h/g)"), "0.072", Unit("s"), values={"h": "1", "g": "386"}))
    t_{1} = \sqrt{\frac{2 \thinspace h}{g}} = \sqrt{\frac{2 \cdot 1}{386}} = 0.072 \thinspace \mathrm{s}
    """
    to = NOTATIONS[notation]
    steps = [to.row(*terms) for terms in _steps(name, formula, value, unit, values, symbols, to)]
    return to.display(to.row(*[part for step in steps for part in (to.sign("=="), step)][1:]))


def pieces(
    name: str,
    formula: Formula,
    value: str = "",
    unit: Unit | None = None,
    *,
    values: Mapping[str, str] | None = None,
    symbols: Mapping[str, str] | None = None,
    notation: str = "mathml",
) -> list[str]:
    r"""`equation` in pieces between which a line may break: before each = and before each term of a sum.

    >>> pieces("x", Formula("a + b"), "3", values={"a": "1", "b": "2"}, notation="latex")
    ['x = a', '+ b', '= 1', '+ 2', '= 3']
    """
    to = NOTATIONS[notation]
    (symbol,), *steps = _steps(name, formula, value, unit, values, symbols, to)
    apart = [(to.sign("=="), first, more) for first, *more in steps]
    lines = [line for equals, first, more in apart for line in (to.row(equals, first), *more)]
    return [to.display(to.row(symbol, *lines[:1])), *map(to.display, lines[1:])]


def _steps(
    name: str,
    formula: Formula,
    value: str,
    unit: Unit | None,
    values: Mapping[str, str] | None,
    symbols: Mapping[str, str] | None,
    to: Notation,
) -> list[list[str]]:
    """The steps of an equation, each as the terms of its sum."""
    tree = formula.tree
    steps = [
        replaced(Name(name), None, symbols),
        replaced(tree, None, symbols),
    ]
    if len(formula.text) <= LONG:
        steps.append(replaced(tree, values, symbols))
    if value:
        steps.append(number(value))
    new = [terms(step, to) for before, step in zip([None, *steps], steps, strict=False) if step != before]
    if value and unit and unit.powers():
        new[-1] = [to.row(*new[-1], to.sign("times"), unit_in(unit.above, unit.below, to))]
    return new
