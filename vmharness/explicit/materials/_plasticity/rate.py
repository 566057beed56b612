"""Dependence on the strain rate: the factor r of the static yield stress.

    Cowper and Symonds   r = 1 + (rate / SRC)^(1 / SRP)
    curve                r piecewise linear over the rate

The rate is the effective rate of the total strain (LS-DYNA: VP = 0), sqrt(2/3 e' : e') of its deviator e'. In uniaxial
flow without change of volume it is the axial rate, so that SRC and SRP of a tensile test hold for every state of
stress.

With VP = 1 it is the plastic strain rate dp/dt, which is an unknown of the yield condition (viscous.py). The viscous
part of the yield stress is then proportional to the static yield stress, or to a constant:

    r Y(p) = Y(p) (1 + z)   or   Y(p) + SIGY z        z = (dp/dt / SRC)^(1 / SRP)
"""

from typing import TypeAlias

from vmharness.deck import Entry
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve, value_and_slope

Viscous: TypeAlias = tuple[float, float, float, float]  # SRC, SRP, A and B of Y(p) + (A + B Y(p)) z
# The curve, else 1 / SRC and 1 / SRP of Cowper and Symonds; or the viscous form.
Rate: TypeAlias = tuple[Curve | None, float, float, Viscous | None]


def cowper_symonds(entry: Entry, c: str, p: str, constant: float = 0.0) -> Rate | None:
    """The parameters from two fields of a material's card; None where both are 0. One alone is a DeckError.

    With VP = 1 the viscous part is proportional to `constant`, or if that is 0 to the static yield stress.
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
    """r by a curve or by Cowper and Symonds; the compiler keeps one of them."""
    if curve is None:
        return 1.0 + (rate * inverse_c) ** inverse_p
    return value_and_slope(curve, rate)[0]


@inlined
def factor(rate: Rate | None, squared: float, dt: float) -> float:
    """r, from the square of the effective strain increment over a step dt, which is 0 before the first step."""
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
    """r of the total strain rate; 1 where the yield condition contains the plastic strain rate."""
    if viscous is not None:
        return 1.0
    return curve_or_power(curve, inverse_c, inverse_p, squared**0.5 / max(dt, 1e-300))


@inlined
def viscous_part(rate: Rate | None) -> Viscous | None:
    """Parameters of the viscous form; None without it."""
    if rate is None:
        return None
    return rate[3]
