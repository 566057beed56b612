"""A piecewise linear function in three forms; beyond the last point it has the last slope.

Up to eight points: a sum over hinges, without a search, so that loops around it vectorise:

    y(x) = y_0 + m_0 (x - x_0) + sum_k (m_k - m_{k-1}) max(0, x - x_k)

with one hinge (x_k, m_k - m_{k-1}) for each inner point. As a tuple: y of the first line at x = 0, m_0, then the
hinges: none or six, of which the surplus ones are zero.

More points: a table with a search that starts from cells of equal width. Each segment has a row: such a sum of its line
and the next two hinges, and then the x up to which this sum is the function, the third hinge.

The last form, for the elements of a block, has the row that each element needs, and no search (long_curves.py). The
table has room for these rows, so that threads must not share a curve.
"""

from typing import TypeAlias

import numpy as np

from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.kernels.vector import inlined, inlined_counted
from vmharness.explicit.state import Array, Index

Hinges: TypeAlias = tuple[float, ...]
# Starts of the segments, cells, rows; then of LANES elements: the selected rows, and a copy of what a step changes.
Table: TypeAlias = tuple[Array, Index, Array, Array, Array]
Curve: TypeAlias = tuple[Hinges, Table | None, Array | None]

HINGES = 6
NEXT = 2  # hinges in a row of the table
END = 2 + 2 * NEXT  # column of the row's end
COLUMNS = END + 1
CELLS = 4  # to a segment
ROOM = 256  # numbers that a step of one element changes, at most


def line(y: float, slope: float) -> Curve:
    """y + slope x."""
    return (y, slope), None, None


def curve(x: Array, y: Array) -> Curve:
    """The function through the points (n,), n >= 2, of increasing x.

    >>> curve(np.array([0.0, 2.0]), np.array([5.0, 6.0]))
    ((5.0, 0.5), None, None)
    """
    slopes = np.diff(y) / np.diff(x)
    start = float(y[0] - slopes[0] * x[0]), float(slopes[0])
    count = len(slopes) - 1
    if count > HINGES:
        return (0.0,) * END, table(x, y, slopes), None
    if count == 0:
        return start, None, None
    hinges = np.zeros((HINGES, 2))
    hinges[:count] = np.column_stack([x[1:-1], np.diff(slopes)])
    return (*start, *hinges.ravel().tolist()), None, None


def is_long(curve: Curve) -> bool:
    """Whether the function has a table."""
    _, table, _ = curve
    return table is not None


def table(x: Array, y: Array, slopes: Array) -> Table:
    """Starts (n - 1,), cells and rows (n - 1, COLUMNS) of the segments; the last rows have fewer hinges and no end.

    Each cell of equal width holds the segment in which it begins, or slightly before, because of round-off.
    """
    rows = np.zeros((len(slopes), COLUMNS))
    rows[:, 0], rows[:, 1], rows[:, END] = y[:-1] - slopes * x[:-1], slopes, np.inf
    for k in range(1, NEXT + 1):
        rows[:-k, 2 * k], rows[:-k, 2 * k + 1] = x[k:-1], np.diff(slopes)[k - 1 :]
    rows[: -NEXT - 1, END] = x[NEXT + 1 : -1]
    starts = x[:-1].copy()
    begin = np.linspace(starts[0], starts[-1], CELLS * starts.size + 1) - 1e-9 * (starts[-1] - starts[0])
    cells = np.maximum(np.searchsorted(starts, begin, side="right") - 1, 0)
    return starts, cells, rows, np.zeros(COLUMNS * LANES), np.zeros(ROOM * LANES)


@inlined
def segment(table: Table, x: float) -> int:
    """The last segment that starts at or before x, or the first; the search starts at the cell of x."""
    starts, cells = table[0], table[1]
    place = (x - starts[0]) / (starts[-1] - starts[0]) * (cells.size - 1)
    k = cells[int(min(place, cells.size - 1.0)) if place > 0.0 else 0]
    while k + 1 < starts.size and x >= starts[k + 1]:
        k += 1
    return k


@inlined
def value_and_slope(curve: Curve, x: float) -> tuple[float, float]:
    """y(x) and dy/dx; at a point the slope before or after it."""
    return evaluate(curve[0], curve[1], x)


@inlined
def evaluate(hinges: Hinges, table: Table | None, x: float) -> tuple[float, float]:
    """y(x) and dy/dx of a sum of hinges or of a table; the compiler keeps one of them."""
    if table is None:
        y, slope = hinges[0] + hinges[1] * x, hinges[1]
        for k in range(2, len(hinges), 2):
            beyond = x - hinges[k]
            y += hinges[k + 1] * max(beyond, 0.0)
            slope += hinges[k + 1] if beyond > 0.0 else 0.0
        return y, slope
    k, rows = segment(table, x), table[2]
    return rows[k, 0] + rows[k, 1] * x, rows[k, 1]


@inlined_counted
def element_curve(curve: Curve, at: int, stride: int) -> Curve:
    """The function of one element of a block, whose history starts at `at`."""
    return curve_of_row(curve[0], curve[1], curve[2], at, stride)


@inlined_counted
def curve_of_row(hinges: Hinges, table: Table | None, selected: Array | None, at: int, stride: int) -> Curve:
    """The function of the selected row at `at`, if there are such rows; the compiler keeps one form."""
    if selected is None:
        return hinges, table, None
    line = selected[at], selected[at + stride]
    first = selected[at + 2 * stride], selected[at + 3 * stride]
    second = selected[at + 4 * stride], selected[at + 5 * stride]
    return (*line, *first, *second), None, None
