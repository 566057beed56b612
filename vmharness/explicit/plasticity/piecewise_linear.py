"""A piecewise linear function without a search: its last slope goes on, so that it is

    y(x) = y_0 + m_0 (x - x_0) + sum_k (m_k - m_{k-1}) max(0, x - x_k)

with one hinge (x_k, m_k - m_{k-1}) for each inner point. As a tuple: y at x = 0 (its first line gone back), m_0, then
the hinges. Tuples come in the few lengths of HINGES, filled with hinges that do nothing: a law is compiled for each.
"""

from typing import TypeAlias

import numpy as np

from vmharness.explicit.state import Array
from vmharness.explicit.vector import inlined

Curve: TypeAlias = tuple[float, ...]

HINGES = (0, 6, 24, 98)


def curve(x: Array, y: Array) -> Curve:
    """The function through the points (n,), n >= 2, of increasing x; ValueError if there are too many.

    >>> curve(np.array([0.0, 2.0]), np.array([5.0, 6.0]))
    (5.0, 0.5)
    """
    slopes = np.diff(y) / np.diff(x)
    hinges = np.column_stack([x[1:-1], np.diff(slopes)]).ravel()
    room = next((2 * count for count in HINGES if 2 * count >= hinges.size), None)
    if room is None:
        raise ValueError(f"{x.size} points; at most {HINGES[-1] + 2} are supported")
    start = y[0] - slopes[0] * x[0]
    return tuple(np.concatenate([[start, slopes[0]], hinges, np.zeros(room - hinges.size)]).tolist())


@inlined
def value_and_slope(curve: Curve, x: float) -> tuple[float, float]:
    """y(x) and dy/dx; at a hinge the slope before it."""
    y, slope = curve[0] + curve[1] * x, curve[1]
    for k in range(2, len(curve), 2):
        beyond = x - curve[k]
        y += curve[k + 1] * max(beyond, 0.0)
        slope += curve[k + 1] if beyond > 0.0 else 0.0
    return y, slope
