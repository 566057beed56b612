"""Yield stress and rate of straining: the factor r of the static yield stress.

    Cowper and Symonds   r = 1 + (rate / SRC)^(1 / SRP)
    curve                r piecewise linear over the rate

The rate is the effective rate of the whole strain (LS-DYNA: VP = 0), sqrt(2/3 e' : e') of its deviator e': in uniaxial
flow, which keeps the volume, the axial rate. So SRC and SRP of a tensile test serve every state of stress.

With VP = 1 it is the plastic strain rate dp/dt, so that the yield condition holds an unknown rate (viscous.py), and the
rate's part of the yield stress is either in proportion to the static one or to a constant:

    r Y(p) = Y(p) (1 + z)   or   Y(p) + SIGY z        z = (dp/dt / SRC)^(1 / SRP)
"""

from typing import TypeAlias

from vmharness.deck import Entry
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve, value_and_slope

Viscous: TypeAlias = tuple[float, float, float, float]  # SRC, SRP, A and B of Y(p) + (A + B Y(p)) z
# The curve, else Cowper-Symonds: 1 / SRC, 1 / SRP; or by the plastic rate.
Rate: TypeAlias = tuple[Curve | None, float, float, Viscous | None]


def cowper_symonds(entry: Entry, c: str, p: str, constant: float = 0.0) -> Rate | None:
    """The parameters from two fields of a material's card; None where both are 0. One alone is a DeckError.

    With VP = 1 the rate's part goes with the `constant`, or if that is 0 with the static yield stress.
    """
    C, P = getattr(entry, c), getattr(entry, p)
    if C == 0.0 and P == 0.0:
        return None
    for given, missing, value in ((c, p, P), (p, c, C)):
        if value == 0.0:
            raise entry.error(missing, f"must be greater than 0, since {given.upper()} is given")
    if entry.vp == 0.0:
        return None, 1.0 / C, 1.0 / P, None
    if P < 1.0:
        raise entry.error(p, "must be at least 1 with VP = 1")
    return None, 1.0 / C, 1.0 / P, (C, P, constant, 0.0 if constant else 1.0)


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
    return factor_of_strain_rate(rate[0], rate[1], rate[2], rate[3], squared, dt)


@inlined
def factor_of_strain_rate(
    curve: Curve | None,
    inverse_c: float,
    inverse_p: float,
    viscous: Viscous | None,
    squared: float,
    dt: float,
) -> float:
    """r, which is 1 where the plastic rate enters the yield condition."""
    if viscous is not None:
        return 1.0
    return curve_or_power(curve, inverse_c, inverse_p, squared**0.5 / max(dt, 1e-300))


@inlined
def viscous_part(rate: Rate | None) -> Viscous | None:
    """What makes the yield stress depend on the plastic rate, if anything does."""
    if rate is None:
        return None
    return rate[3]
