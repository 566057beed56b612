"""The yield condition at the end of a step of radial or uniaxial return: one equation for the increment of p.

    f(dp) = trial - K dp - r Y(p + dp) = 0

`trial` is q (or |s|) of the elastic trial stress, which falls by K dp: K = 3 G + C, or E + C in uniaxial stress.
"""

from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve, value_and_slope
from vmharness.explicit.materials._plasticity.rate import Viscous
from vmharness.explicit.materials._plasticity.viscous import viscous_increment

ITERATIONS = 5


@inlined
def static_increment(trial: float, K: float, p: float, r: float, Y: Curve) -> float:
    """dp >= 0, by Newton's rule; 0 where the trial stress is elastic.

    Exact in one step if p passes no corner of Y. Each corner takes one more step, or leaves an error far below the
    round-off of E dp, since the slope of Y is small against K.
    """
    dp = 0.0
    for _ in range(ITERATIONS):
        y, slope = value_and_slope(Y, p + dp)
        dp = max(0.0, dp + (trial - K * dp - r * y) / (K + r * slope))
    return dp


@inlined
def increment(
    trial: float, K: float, p: float, r: float, Y: Curve, viscous: Viscous | None, dt: float
) -> float:
    """dp >= 0, by the static or the viscous form; the compiler keeps one of them."""
    if viscous is None:
        return static_increment(trial, K, p, r, Y)
    return viscous_increment(trial, K, p, Y, viscous, dt)
