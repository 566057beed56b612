"""Typeset lines of theory and data, in LaTeX and in MathML."""

from dataclasses import dataclass

from vmharness.formula import Formula, Unit, equation, pieces
from vmharness.report.number import given, short
from vmharness.report.page import Datum, Page, TheoryLine
from vmharness.report.width import ems

LONG = 40.0  # em: more does not fit beside the words of the line


@dataclass(frozen=True)
class Pieces:
    """The <math> elements of a line, each with its width in em for the style of the page."""

    pieces: list[str]
    is_long: bool  # whether one of them needs the whole width of the page


def theory(line: TheoryLine, page: Page) -> str:
    """LaTeX: symbol = formula = formula with values = value unit; a curve over time ends with its formula."""
    if line.value is None:
        return equation(line.name, line.formula)
    return equation(line.name, line.formula, short(line.value), line.unit, values=_values(line, page))


def theory_pieces(line: TheoryLine, page: Page) -> Pieces:
    """The same as MathML, in pieces between which a page may break the line."""
    if line.value is None:
        parts = pieces(line.name, line.formula)
    else:
        parts = pieces(line.name, line.formula, short(line.value), line.unit, values=_values(line, page))
    widths = [ems(part) for part in parts]
    sized = [f' displaystyle="true" style="--ems: {width}"' for width in widths]
    inline = [part.replace(' display="block"', size) for part, size in zip(parts, sized, strict=True)]
    return Pieces(inline, max(widths) > LONG)


def _values(line: TheoryLine, page: Page) -> dict[str, str]:
    """The values of the names in a line."""
    case = page.run.case
    return {
        name: short(values[name])
        for values in (case.given, case.theory)
        for name in line.formula.names & values.keys()
    }


def datum(datum: Datum, notation: str) -> str:
    """symbol = value unit."""
    value = given(datum.value)
    return equation(datum.name, Formula(value), value, Unit(datum.unit), notation=notation)
