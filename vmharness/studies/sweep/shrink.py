"""The simplest failing point: as few data as possible differ from those of the case."""

from collections.abc import Callable, Mapping, Sequence

from vmharness.round_off import rounded
from vmharness.studies.sweep.sampling import DIGITS, Point

Fails = Callable[[Sequence[Point]], Sequence[bool]]

ROUNDS = 40  # largest number of steps


def shrink(point: Point, own: Mapping[str, float], fails: Fails) -> Point:
    """The data of the simplest point that differ from the case's `own`; a step is kept if its point still fails.

    A step sets one datum to the value of the case; if no such point fails, one datum gets fewer digits; else one datum
    goes half-way to the value of the case. All steps of a kind are run together, and the first that fails is kept.
    """
    found = {name: value for name, value in point.items() if value != own[name]}
    for _ in range(ROUNDS):
        step = next(filter(None, (_first(kind(found, own), fails) for kind in KINDS)), None)
        if step is None:
            return found
        found = step
    return found


def _first(attempts: Sequence[Point], fails: Fails) -> Point | None:
    """The first attempt that fails."""
    still = fails(attempts) if attempts else ()
    return next((attempt for attempt, fail in zip(attempts, still, strict=True) if fail), None)


def _without(point: Point, own: Mapping[str, float]) -> list[Point]:
    """Points with one datum less, if more than one is left."""
    return [{k: v for k, v in point.items() if k != name} for name in point] if len(point) > 1 else []


def _shorter(point: Point, own: Mapping[str, float]) -> list[Point]:
    """Points with fewer digits of one datum, the fewest first."""
    return [
        {**point, name: short}
        for name, value in point.items()
        for digits in range(1, DIGITS)
        if (short := rounded(value, digits)) not in (value, own[name])
    ]


def _nearer(point: Point, own: Mapping[str, float]) -> list[Point]:
    """Points with one datum half-way to the value of the case."""
    return [
        {**point, name: half}
        for name, value in point.items()
        if (half := _half_way(value, own[name])) not in (value, own[name])
    ]


def _half_way(value: float, own: float) -> float:
    """In the middle, by two digits: of a difference below a tenth nothing is left to halve."""
    if abs(value - own) <= 0.1 * abs(own):
        return value
    return rounded(0.5 * (value + own), 2)


KINDS = (_without, _shorter, _nearer)
