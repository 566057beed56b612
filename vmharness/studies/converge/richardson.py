"""Order of accuracy and extrapolated value from a sequence of refinements.

For sizes h_1 > h_2 > ... > h_n a value in its asymptotic range is f = f_0 + C h^p. Three levels give

    (h_1^p - h_2^p) / (h_2^p - h_3^p) = (f_1 - f_2) / (f_2 - f_3)      gives p,
    f_0 = f_3 + (f_3 - f_2) / (r^p - 1),  r = h_2/h_3                  (Richardson's extrapolation),
    GCI = Fs |f_3 - f_2| / (r^p - 1)                                   (grid convergence index, Fs = 1.25).

P. J. Roache, Verification and Validation in Computational Science and Engineering, Hermosa (1998), chapter 5. The order
is that of the three finest levels; its uncertainty is the largest difference from the order of any other three
successive levels.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

SAFETY = 1.25  # Roache's factor for three levels or more
ROUND_OFF = 1e-9  # of a value: values that differ by less are equal
SPREAD = 0.25  # of an order: if orders differ by more, the levels are not in the asymptotic range
HIGHEST = 16.0  # largest order that is searched for


class Kind(StrEnum):
    """Behaviour of a value under refinement."""

    CONVERGES = "converges"
    EXACT = "exact"  # the same at every level
    OSCILLATES = "oscillates"
    DIVERGES = "does not converge"
    NOT_ASYMPTOTIC = "not asymptotic"
    NO_VALUE = "no value"  # at some level


@dataclass(frozen=True)
class Richardson:
    """Result of the extrapolation; the numbers are None if the sequence has no order."""

    kind: Kind
    order: float | None = None
    uncertainty: float | None = (
        None  # of the order: largest distance of another three's; None of three levels alone
    )
    extrapolated: float | None = None
    gci: float | None = None  # in the unit of the value


def richardson(sizes: Sequence[float], values: Sequence[float | None], promised: float | None) -> Richardson:
    """Extrapolate `values` at decreasing `sizes`, of which there are at least three.

    The GCI uses the `promised` order if the observed one is higher.
    """
    f = [value for value in values if value is not None]
    if len(f) < len(values):
        return Richardson(Kind.NO_VALUE)
    if max(f) - min(f) <= ROUND_OFF * max(map(abs, f)):
        return Richardson(Kind.EXACT, extrapolated=f[-1], gci=ROUND_OFF * abs(f[-1]))
    orders = [order(sizes[i : i + 3], f[i : i + 3]) for i in range(len(f) - 2)]
    known = [each for each in orders if isinstance(each, float)]
    if isinstance(orders[-1], Kind):
        return Richardson(orders[-1])
    finest = orders[-1]
    uncertainty = max((abs(each - finest) for each in known[:-1]), default=None)
    if len(known) < len(orders) or (uncertainty or 0.0) > SPREAD * finest:
        return Richardson(Kind.NOT_ASYMPTOTIC)
    ratio, step = sizes[-2] / sizes[-1], f[-1] - f[-2]
    trusted = min(finest, promised or finest)
    return Richardson(
        Kind.CONVERGES,
        order=finest,
        uncertainty=uncertainty,
        extrapolated=f[-1] + step / (ratio**finest - 1.0),
        gci=SAFETY * abs(step) / (ratio**trusted - 1.0),
    )


def order(h: Sequence[float], f: Sequence[float]) -> float | Kind:
    """The order p of three levels, or the reason why they have none.

    >>> round(order([0.4, 0.2, 0.1], [1.16, 1.04, 1.01]), 9)
    2.0
    >>> order([4.0, 2.0, 1.0], [1.0, -1.0, 1.0])
    <Kind.OSCILLATES: 'oscillates'>
    """
    from scipy.optimize import brentq

    coarse, fine = f[0] - f[1], f[1] - f[2]
    if fine == 0.0 or coarse == 0.0:
        return Kind.NOT_ASYMPTOTIC
    quotient = coarse / fine
    if quotient < 0.0:
        return Kind.OSCILLATES

    def excess(p: float) -> float:
        a, b = h[0] / h[2], h[1] / h[2]
        return (a**p - b**p) / (b**p - 1.0) - quotient

    lowest = 1e-3
    if excess(lowest) >= 0.0:
        return Kind.DIVERGES
    if excess(HIGHEST) <= 0.0:
        return Kind.NOT_ASYMPTOTIC
    return float(brentq(excess, lowest, HIGHEST, xtol=1e-12))
