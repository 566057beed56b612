"""A piecewise linear function, whose last slope goes on beyond the last point, in two forms.

Up to eight points: a sum over hinges, without a search, so that loops around it vectorise:

    y(x) = y_0 + m_0 (x - x_0) + sum_k (m_k - m_{k-1}) max(0, x - x_k)

with one hinge (x_k, m_k - m_{k-1}) for each inner point. As a tuple: y at x = 0 (the first line gone back), m_0, then
the hinges: none or six, those that are too many do nothing. More points: a table of x_k, y_k, m_k that is searched.
"""

from typing import TypeAlias

import numpy as np

from vmharness.explicit.state import Array
from vmharness.explicit.vector import inlined

Hinges: TypeAlias = tuple[float, ...]
Curve: TypeAlias = tuple[Hinges, Array | None]

HINGES = 6


def line(y: float, slope: float) -> Curve:
    """y + slope x."""
    return (y, slope), None


def curve(x: Array, y: Array) -> Curve:
    """The function through the points (n,), n >= 2, of increasing x.

    >>> curve(np.array([0.0, 2.0]), np.array([5.0, 6.0]))
    ((5.0, 0.5), None)
    """
    slopes = np.diff(y) / np.diff(x)
    start = float(y[0] - slopes[0] * x[0]), float(slopes[0])
    count = len(slopes) - 1
    if count > HINGES:
        return start, np.column_stack([x[:-1], y[:-1], slopes])
    if count == 0:
        return start, None
    hinges = np.zeros((HINGES, 2))
    hinges[:count] = np.column_stack([x[1:-1], np.diff(slopes)])
    return (*start, *hinges.ravel().tolist()), None


@inlined
def value_and_slope(curve: Curve, x: float) -> tuple[float, float]:
    """y(x) and dy/dx; at a point the slope before it."""
    return by_form(curve[0], curve[1], x)


@inlined
def by_form(hinges: Hinges, table: Array | None, x: float) -> tuple[float, float]:
    """The same; the compiler keeps one form."""
    if table is None:
        y, slope = hinges[0] + hinges[1] * x, hinges[1]
        for k in range(2, len(hinges), 2):
            beyond = x - hinges[k]
            y += hinges[k + 1] * max(beyond, 0.0)
            slope += hinges[k + 1] if beyond > 0.0 else 0.0
        return y, slope
    k = 0
    while k + 1 < len(table) and x > table[k + 1, 0]:
        k += 1
    return table[k, 1] + table[k, 2] * (x - table[k, 0]), table[k, 2]
