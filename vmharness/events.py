"""Events, found between samples: onset, end, level crossing, extremum.

A value read at the nearest sample is the output interval's, not the solver's. Each event comes with the uncertainty
that sampling leaves: how far it moves when only every second sample is kept.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Direction = Literal["up", "down"]


ROUND_OFF = 1e-6  # of a step: a contact that begins just at a sample is found on either side of it


class EventError(ValueError):
    """An event did not happen, or not as often as declared, or cannot be located."""


@dataclass(frozen=True)
class Event:
    """When an event happened, and how far the sampling leaves that open; consistent units of time."""

    time: float
    uncertainty: float


def onsets(time: Array, values: Array) -> list[float]:
    """Times at which a channel that was exactly zero begins: extrapolated backward to its root.

    A force has a kink at its onset, so nothing is interpolated across it: the parabola through the first three
    non-zero samples is followed back to zero. The root must lie in the step before them, (t_0, t_1]; where fewer
    than three samples are non-zero, or the parabola has no root there, the line through the first two must have one.
    Raises EventError where neither locates it.
    """
    on = values != 0.0
    first = np.flatnonzero(on[1:] & ~on[:-1]) + 1
    return [_root_beside(time, values, int(i), 1) for i in first]


def ends(time: Array, values: Array) -> list[float]:
    """Times at which a channel becomes exactly zero: extrapolated forward from its last non-zero samples.

    The mirror of `onsets`, in the step after the last non-zero sample.
    """
    on = values != 0.0
    last = np.flatnonzero(on[:-1] & ~on[1:])
    return [_root_beside(time, values, int(i), -1) for i in last]


def _root_beside(time: Array, values: Array, i: int, along: int) -> float:
    """The root in the step before sample i of the parabola, or the line, through i and what follows `along` (+-1)."""
    step = time[i] - time[i - along]
    for points in (3, 2):
        j = i + along * np.arange(points)
        if not 0 <= j[-1] < time.size or np.any(values[j] == 0.0):
            continue
        s = (time[j] - time[i]) / step
        roots = np.roots(np.polyfit(s, values[j], points - 1))
        # A force that begins without a kink has a double root, which round-off makes a complex pair.
        real = roots[np.abs(roots.imag) < 1e-3].real
        inside = real[(real >= -1.0 - ROUND_OFF) & (real <= ROUND_OFF)]
        if inside.size:
            return float(time[i] + step * np.clip(inside.max(), -1.0, 0.0))
    what, (first, last) = "begins" if along == 1 else "ends", sorted((time[i - along], time[i]))
    raise EventError(f"{what} between {first:.7g} and {last:.7g}, but cannot be located within that step")


def crossings(time: Array, values: Array, level: float, direction: Direction) -> list[float]:
    """Times at which a channel passes `level` upward or downward: roots of the cubic Hermite interpolant.

    A channel that touches the level and turns back does not cross it; one that rests on it crosses when it leaves.
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
    return float(
        time[i] + brentq(lambda s: float(cubic(s)), 0.0, time[i + 1] - time[i], xtol=1e-300, rtol=1e-14)
    )


def minima(time: Array, values: Array) -> list[float]:
    """Times of the lowest values: vertices of the parabola through the lowest sample and its neighbours.

    A valley counts when both its sides rise above it by a thousandth of the channel's range, so that round-off and
    ripple are no events. Ends of the run are not minima: what still falls there has not turned yet.
    """
    return [_vertex(time, values, i) for i in _valleys(values, 1e-3 * float(np.ptp(values)))]


def _valleys(values: Array, rise: float) -> list[int]:
    """Indices of the lowest samples of the valleys that are deeper than `rise` on both sides."""
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
    """The vertex of the parabola through the samples i-1, i, i+1."""
    a, b = time[i - 1] - time[i], time[i + 1] - time[i]
    left, right = (values[i - 1] - values[i]) / a, (values[i + 1] - values[i]) / b  # divided differences
    curvature = (right - left) / (b - a)
    return float(time[i] - 0.5 * (left - curvature * a) / curvature)


def find(
    locate: Callable[[Array, Array], list[float]], time: Array, values: Array, times: int, pick: int
) -> Event:
    """The `pick`-th of the `times` events that `locate` finds, with the uncertainty that sampling leaves.

    Raises EventError when the event happens less or more often than `times`.
    """
    if not np.all(np.isfinite(values)):
        raise EventError("has samples that are not finite")
    found = locate(time, values)
    if len(found) != times:
        at = f", at {', '.join(f'{t:.7g}' for t in found[:5])}" if found else ""
        often = "did not happen" if not found else f"happened {len(found)} times{at}"
        raise EventError(f"{often} within the run, to {time[-1]:.7g}; {times} declared")
    try:
        coarse = locate(time[::2], values[::2])
    except EventError:
        coarse = []
    if len(coarse) != times:  # too short for every second sample
        return Event(found[pick - 1], 2.0 * float(np.diff(time).max()))
    return Event(found[pick - 1], abs(coarse[pick - 1] - found[pick - 1]))
