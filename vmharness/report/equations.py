"""Typeset lines of theory and data."""

from vmharness.formula import Formula, Unit, equation
from vmharness.report.number import given, short
from vmharness.report.page import Datum, Page, TheoryLine


def theory(line: TheoryLine, page: Page, notation: str) -> str:
    """symbol = formula = formula with values = value unit; a curve over time ends with its formula."""
    if line.value is None:
        return equation(line.name, line.formula, notation=notation)
    values = {name: short(value) for name, value in page.run.case.values.items()}
    return equation(line.name, line.formula, short(line.value), line.unit, values=values, notation=notation)


def datum(datum: Datum, notation: str) -> str:
    """symbol = value unit."""
    value = given(datum.value)
    return equation(datum.name, Formula(value), value, Unit(datum.unit), notation=notation)
