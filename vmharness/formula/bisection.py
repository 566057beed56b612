"""Root of a function, by bisection."""

from collections.abc import Callable

import numpy as np

from vmharness.formula.scope import Value

STEPS = 100  # the interval shrinks by 2^-100: to the last digit, unless the root is that near to zero


def bisection(f: Callable[[Value], Value], low: Value, high: Value) -> Value:
    """The x in [low, high] where f changes its sign, at all points at once; arrays of one shape, or scalars.

    ValueError if f has one sign at both ends, or changes it through infinity.

    >>> float(bisection(np.cos, np.float64(1), np.float64(2)))
    1.5707963267948966
    """
    if np.any(low >= high):
        raise ValueError("the lower bound is not below the upper")
    at_low, at_high = f(low), f(high)
    if np.any(np.sign(at_low) * np.sign(at_high) > 0):
        raise ValueError("no change of sign between the bounds")
    for _ in range(STEPS):
        middle = low + (high - low) / 2
        before = np.sign(f(middle)) == np.sign(at_low)
        low, high = np.where(before, middle, low)[()], np.where(before, high, middle)[()]
    a, b = np.abs(f(low)), np.abs(f(high))
    if np.any(np.minimum(a, b) > np.maximum(np.abs(at_low), np.abs(at_high))):
        raise ValueError("the sign changes through a pole, not through zero")
    nearest: Value = np.where(a <= b, low, high)
    return nearest[()]
