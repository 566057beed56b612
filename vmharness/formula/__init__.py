"""Formulas with units: parsed against a whitelist, checked, evaluated on numbers or arrays, typeset."""

from vmharness.formula.dimension import DIMENSIONLESS, Dimension
from vmharness.formula.equation import equation, pieces
from vmharness.formula.error import FormulaError, UnitError
from vmharness.formula.formula import Formula
from vmharness.formula.system import UnitSystem
from vmharness.formula.unit import Unit

__all__ = [
    "DIMENSIONLESS",
    "Dimension",
    "Formula",
    "FormulaError",
    "Unit",
    "UnitError",
    "UnitSystem",
    "equation",
    "pieces",
]
