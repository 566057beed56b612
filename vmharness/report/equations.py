"""Typeset lines of theory and data, in LaTeX and in MathML."""

from vmharness.formula import Formula, Unit, equation, pieces
from vmharness.report.number import given, short
from vmharness.report.page import Datum, Page, TheoryLine
from vmharness.report.width import ems


def theory(line: TheoryLine, page: Page) -> str:
    """LaTeX: symbol = formula = formula with values = value unit; a curve over time ends with its formula."""
    if line.value is None:
        return equation(line.name, line.formula)
    return equation(line.name, line.formula, short(line.value), line.unit, values=_values(page))


def theory_pieces(line: TheoryLine, page: Page) -> list[str]:
    """The same as MathML, in pieces between which a page may break the line, each with its width in em."""
    if line.value is None:
        parts = pieces(line.name, line.formula)
    else:
        parts = pieces(line.name, line.formula, short(line.value), line.unit, values=_values(page))
    return [
        part.replace(' display="block"', f' displaystyle="true" style="--ems: {ems(part)}"') for part in parts
    ]


def _values(page: Page) -> dict[str, str]:
    return {name: short(value) for name, value in page.run.case.values.items()}


def datum(datum: Datum, notation: str) -> str:
    """symbol = value unit."""
    value = given(datum.value)
    return equation(datum.name, Formula(value), value, Unit(datum.unit), notation=notation)
