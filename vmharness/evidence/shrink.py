"""A failing point made simpler, as long as it fails: the fewer data differ from the case's own, the better."""

from collections.abc import Callable, Mapping, Sequence

from vmharness.evidence.sample import DIGITS, Point, rounded

Fails = Callable[[Sequence[Point]], Sequence[bool]]

ROUNDS = 40  # batches of attempts at most


def shrink(point: Point, own: Mapping[str, float], fails: Fails) -> Point:
    """The data that still differ from the case's `own`, after each step that `fails` lets pass has been taken.

    Every round asks for all that could be done next at once, and does the first that still fails: first a datum back to
    its own value, then fewer digits of one, then one half-way back.
    """
    found = {name: value for name, value in point.items() if value != own[name]}
    for _ in range(ROUNDS):
        attempts = [attempt for attempt in _simpler(found, own) if attempt != found]
        if not attempts:
            return found
        still = fails(attempts)
        if not any(still):
            return found
        found = next(attempt for attempt, fail in zip(attempts, still, strict=True) if fail)
    return found


def _simpler(point: Point, own: Mapping[str, float]) -> list[Point]:
    """What to try, the simplest first."""
    without = [{k: v for k, v in point.items() if k != name} for name in point] if len(point) > 1 else []
    short = [
        {**point, name: rounded(value, digits)}
        for name, value in point.items()
        for digits in range(1, DIGITS)
        if rounded(value, digits) != value and rounded(value, digits) != own[name]
    ]
    nearer = [
        {**point, name: half}
        for name, value in point.items()
        if (half := _half_way(value, own[name])) not in (value, own[name])
    ]
    return [*without, *short, *nearer]


def _half_way(value: float, own: float) -> float:
    """In the middle, by two digits: of a difference below a tenth nothing is left to halve."""
    if abs(value - own) <= 0.1 * abs(own):
        return value
    return rounded(0.5 * (value + own), 2)
