"""A failing point made simpler, as long as it fails: the fewer data differ from the case's own, the better."""

from collections.abc import Callable, Mapping, Sequence

from vmharness.round_off import rounded
from vmharness.studies.sweep.sampling import DIGITS, Point

Fails = Callable[[Sequence[Point]], Sequence[bool]]

ROUNDS = 40  # steps at most


def shrink(point: Point, own: Mapping[str, float], fails: Fails) -> Point:
    """The data that still differ from the case's `own`, after each step that `fails` lets pass has been taken.

    A step is a datum back to its own value; where none can go back, fewer digits of one; else one half-way back. All
    steps of a kind are asked for at once, and the first that still fails is taken.
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
    """One datum less, as long as one is left."""
    return [{k: v for k, v in point.items() if k != name} for name in point] if len(point) > 1 else []


def _shorter(point: Point, own: Mapping[str, float]) -> list[Point]:
    """One datum with fewer digits, the fewest first."""
    return [
        {**point, name: short}
        for name, value in point.items()
        for digits in range(1, DIGITS)
        if (short := rounded(value, digits)) not in (value, own[name])
    ]


def _nearer(point: Point, own: Mapping[str, float]) -> list[Point]:
    """One datum half-way back."""
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
