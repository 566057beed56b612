"""The table of units: symbol, factor to SI, dimension."""

import math
from collections.abc import Mapping
from fractions import Fraction

from vmharness.formula.dimension import DIMENSIONLESS, FORCE, LENGTH, MASS, TEMPERATURE, TIME, Dimension

STRESS, ENERGY, POWER = FORCE / LENGTH**2, FORCE * LENGTH, FORCE * LENGTH / TIME
FREQUENCY = DIMENSIONLESS / TIME

INCH, FOOT, POUND = Fraction("0.0254"), Fraction("0.3048"), Fraction("0.45359237")
POUND_FORCE = POUND * Fraction("9.80665")
PI = Fraction(math.pi)

# Factors to SI, exact by definition of the unit (but for pi); a temperature is a difference.
_FACTORS: Mapping[Dimension, Mapping[str, Fraction | str | int]] = {
    DIMENSIONLESS: {"rad": 1, "deg": PI / 180, "rev": 2 * PI},
    LENGTH: {"m": 1, "km": 1000, "cm": "1e-2", "mm": "1e-3", "um": "1e-6", "in": INCH, "ft": FOOT},
    TIME: {"s": 1, "sec": 1, "ms": "1e-3", "us": "1e-6", "min": 60, "h": 3600, "hr": 3600},
    MASS: {
        "kg": 1,
        "g": "1e-3",
        "mg": "1e-6",
        "t": 1000,
        "tonne": 1000,
        "lbm": POUND,
        "slug": POUND_FORCE / FOOT,
    },
    TEMPERATURE: {"K": 1, "C": 1, "F": Fraction(5, 9), "R": Fraction(5, 9)},
    FREQUENCY: {"Hz": 1, "kHz": 1000, "MHz": 10**6, "rpm": 2 * PI / 60},
    FORCE: {"N": 1, "mN": "1e-3", "kN": 1000, "MN": 10**6, "lbf": POUND_FORCE, "kip": 1000 * POUND_FORCE},
    STRESS: {"Pa": 1, "kPa": 1000, "MPa": 10**6, "GPa": 10**9, "bar": 10**5}
    | {"psi": POUND_FORCE / INCH**2, "ksi": 1000 * POUND_FORCE / INCH**2},
    ENERGY: {"J": 1, "mJ": "1e-3", "kJ": 1000, "MJ": 10**6, "Btu": Fraction("1055.05585262")},
    POWER: {"W": 1, "mW": "1e-3", "kW": 1000, "MW": 10**6},
}
SYMBOLS: Mapping[str, tuple[Fraction, Dimension]] = {
    symbol: (Fraction(factor), dimension)
    for dimension, symbols in _FACTORS.items()
    for symbol, factor in symbols.items()
}
AMBIGUOUS = {"lb": "lbf (force) or lbm (mass)", "lbs": "lbf (force) or lbm (mass)", "ton": "t (1000 kg)"}
