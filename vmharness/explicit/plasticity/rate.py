"""Yield stress and rate of straining: the factor r of the static yield stress.

    Cowper and Symonds   r = 1 + (rate / SRC)^(1 / SRP)
    curve                r piecewise linear over the rate

The rate is the effective rate of the whole strain (LS-DYNA: VP = 0), sqrt(2/3 e' : e') of its deviator e': in uniaxial
flow, which keeps the volume, the axial rate. So SRC and SRP of a tensile test serve every state of stress.
"""

from typing import TypeAlias

from vmharness.deck import Entry
from vmharness.explicit.plasticity.piecewise_linear import Curve, value_and_slope
from vmharness.explicit.vector import inlined

Rate: TypeAlias = tuple[Curve | None, float, float]  # the curve, else Cowper-Symonds: 1 / SRC, 1 / SRP


def cowper_symonds(entry: Entry, c: str, p: str) -> Rate | None:
    """The parameters from two fields of a material's card; None where both are 0. One alone is a DeckError."""
    C, P = getattr(entry, c), getattr(entry, p)
    if C == 0.0 and P == 0.0:
        return None
    for given, missing, value in ((c, p, P), (p, c, C)):
        if value == 0.0:
            raise entry.error(missing, f"must be greater than 0, since {given.upper()} is given")
    return None, 1.0 / C, 1.0 / P


@inlined
def curve_or_power(curve: Curve | None, inverse_c: float, inverse_p: float, rate: float) -> float:
    """r by either form; the compiler keeps one."""
    if curve is None:
        return 1.0 + (rate * inverse_c) ** inverse_p
    return value_and_slope(curve, rate)[0]


@inlined
def factor(rate: Rate | None, squared: float, dt: float) -> float:
    """r, from the square of the effective strain increment over a step dt (0 before the first: nothing moved)."""
    if rate is None:
        return 1.0
    return curve_or_power(rate[0], rate[1], rate[2], squared**0.5 / max(dt, 1e-300))
