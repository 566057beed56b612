"""Events between samples: onset, end, level crossing, extremum.

A value at the nearest sample would depend on the output interval. Each event has an uncertainty: the change of its time
if only every second sample is used.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Direction = Literal["up", "down"]


ROUND_OFF = (
    1e-6  # of a step: the root of a contact that begins exactly at a sample may be on either side of it
)


class EventError(ValueError):
    """An event did not happen, happened more or less often than declared, or cannot be located."""


@dataclass(frozen=True)
class Event:
    """The time of an event, and its uncertainty by sampling; consistent units."""

    time: float
    uncertainty: float


def onsets(time: Array, values: Array) -> list[float]:
    """Times at which a channel that was exactly zero begins, by backward extrapolation.

    A force has a kink at its onset, so interpolation across it would be wrong: the parabola through the first three
    non-zero samples is extrapolated to zero. The root must be in the step before them, (t_0, t_1]. If fewer than three
    samples are non-zero, or if the parabola has no root there, the line through the first two samples is used.
    Raises EventError if neither has a root there.
    """
    on = values != 0.0
    first = np.flatnonzero(on[1:] & ~on[:-1]) + 1
    return [_root_beside(time, values, int(i), 1) for i in first]


def ends(time: Array, values: Array) -> list[float]:
    """Times at which a channel becomes exactly zero, by forward extrapolation.

    As `onsets`, with the last non-zero samples and the step after them.
    """
    on = values != 0.0
    last = np.flatnonzero(on[:-1] & ~on[1:])
    return [_root_beside(time, values, int(i), -1) for i in last]


def _root_beside(time: Array, values: Array, i: int, along: int) -> float:
    """The root, in the step before sample i, of the parabola or line through i and the next samples `along` (+-1)."""
    step = time[i] - time[i - along]
    for points in (3, 2):
        j = i + along * np.arange(points)
        if not 0 <= j[-1] < time.size or np.any(values[j] == 0.0):
            continue
        s = (time[j] - time[i]) / step
        roots = np.roots(np.polyfit(s, values[j], points - 1))
        # A force without a kink has a double root, which becomes a complex pair by round-off.
        real = roots[np.abs(roots.imag) < 1e-3].real
        inside = real[(real >= -1.0 - ROUND_OFF) & (real <= ROUND_OFF)]
        if inside.size:
            return float(time[i] + step * np.clip(inside.max(), -1.0, 0.0))
    what, (first, last) = "begins" if along == 1 else "ends", sorted((time[i - along], time[i]))
    raise EventError(f"{what} between {first:.7g} and {last:.7g}, but cannot be located within that step")


def crossings(time: Array, values: Array, level: float, direction: Direction) -> list[float]:
    """Times at which a channel crosses `level` upward or downward: roots of the cubic Hermite interpolant.

    A channel that touches the level and reverses does not cross it; one that stays on the level crosses when it leaves.
    """
    sign = 1.0 if direction == "up" else -1.0
    above = sign * (values - level) > 0.0
    passed = np.flatnonzero(above[1:] & ~above[:-1])
    return [_hermite_root(time, values - level, int(i)) for i in passed]


def _hermite_root(time: Array, values: Array, i: int) -> float:
    """The root between samples i and i + 1."""
    from scipy.interpolate import CubicHermiteSpline
    from scipy.optimize import brentq

    if values[i] == 0.0:
        return float(time[i])
    near = slice(max(i - 2, 0), i + 4)
    t, y = time[near] - time[i], values[near]
    cubic = CubicHermiteSpline(t, y, np.gradient(y, t, edge_order=2 if t.size > 2 else 1))
    try:
        root = brentq(lambda s: float(cubic(s)), 0.0, time[i + 1] - time[i], xtol=1e-300, rtol=1e-14)
    except ValueError:  # a power of the step overflows
        raise EventError(f"cannot be located within a step of {time[i + 1] - time[i]:g}") from None
    return float(time[i] + root)


def minima(time: Array, values: Array) -> list[float]:
    """Times of minima: vertices of the parabola through the lowest sample and its neighbours.

    A minimum counts if the channel rises on both sides by a thousandth of its range, so round-off and ripple are no
    events. The ends of the run are no minima.
    """
    return [_vertex(time, values, i) for i in _valleys(values, 1e-3 * float(np.ptp(values)))]


def _valleys(values: Array, rise: float) -> list[int]:
    """Indices of the lowest samples of all valleys that are deeper than `rise` on both sides."""
    found: list[int] = []
    if rise == 0.0:
        return found
    high, low, falling = 0, 0, False
    for i in range(1, values.size):
        if falling:
            if values[i] < values[low]:
                low = i
            elif values[i] > values[low] + rise:
                found.append(low)
                falling, high = False, i
        elif values[i] > values[high]:
            high = i
        elif values[i] < values[high] - rise:
            falling, low = True, i
    return found


def _vertex(time: Array, values: Array, i: int) -> float:
    """The vertex of the parabola through the samples i-1, i, i+1; sample i if they lie on a line."""
    a, b = time[i - 1] - time[i], time[i + 1] - time[i]
    left, right = (values[i - 1] - values[i]) / a, (values[i + 1] - values[i]) / b  # divided differences
    curvature = (right - left) / (b - a)
    return float(time[i] - 0.5 * (left - curvature * a) / curvature) if curvature else float(time[i])


def find(
    locate: Callable[[Array, Array], list[float]], time: Array, values: Array, times: int, pick: int
) -> Event:
    """Event number `pick` of the `times` events that `locate` finds, with its uncertainty by sampling.

    Raises EventError if the number of events is not `times`.
    """
    if not np.all(np.isfinite(values)):
        raise EventError("has samples that are not finite")
    found = locate(time, values)
    if len(found) != times:
        at = f", at {', '.join(f'{t:.7g}' for t in found[:5])}" if found else ""
        often = "did not happen" if not found else f"happened {len(found)} times{at}"
        raise EventError(f"{often} within the run, which ends at {time[-1]:.7g}; the case declares {times}")
    try:
        coarse = locate(time[::2], values[::2])
    except EventError:
        coarse = []
    if len(coarse) != times:  # too few samples for this
        return Event(found[pick - 1], 2.0 * float(np.diff(time).max()))
    return Event(found[pick - 1], abs(coarse[pick - 1] - found[pick - 1]))
