"""Round-off: digits and orders that do not depend on the last bits of numbers, so that every machine writes one page.

Verdicts never use them.
"""

from collections.abc import Callable, Iterable
from typing import TypeVar

Item = TypeVar("Item")

ROUND_OFF = 1e-12  # of a target: a run's distance from it that is not larger is round-off
AGREE = 1e-6  # relative: numbers that differ by less are equal where they are put in order
DIGITS = 9  # of a number that is printed with fewer, so that 0.125 and 0.12499999999999999 print alike


def rounded(value: float, digits: int = DIGITS) -> float:
    """`value` to so many significant digits.

    >>> rounded(0.1 + 0.2), rounded(1234.5678, 3)
    (0.3, 1230.0)
    """
    return float(f"{value:.{digits - 1}e}")


def ordered(items: Iterable[Item], value: Callable[[Item], float], least: float = 0.0) -> list[Item]:
    """The items by rising value; those whose values agree to round-off in the order in which they come.

    Neighbours agree if they differ by less than AGREE of the larger one, or by not more than `least`.

    >>> ordered(["a", "b", "c"], {"a": 0.1 + 0.2, "b": 0.3, "c": 0.1}.get)
    ['c', 'a', 'b']
    """
    numbered = sorted(
        ((value(item), place, item) for place, item in enumerate(items)), key=lambda one: one[0]
    )
    groups: list[list[tuple[float, int, Item]]] = []
    for one in numbered:
        if groups and _agree(groups[-1][-1][0], one[0], least):
            groups[-1].append(one)
        else:
            groups.append([one])
    return [item for group in groups for _, _, item in sorted(group, key=lambda one: one[1])]


def smallest(items: Iterable[Item], value: Callable[[Item], float]) -> Item:
    """The item of the smallest value; the first of those that agree to round-off. There must be one.

    >>> smallest([0.1 + 0.2, 0.3, 1.0], lambda x: x)
    0.30000000000000004
    """
    return ordered(items, value)[0]


def largest(items: Iterable[Item], value: Callable[[Item], float]) -> Item:
    """The item of the largest value; the first of those that agree to round-off. There must be one.

    >>> largest([0.1, 0.3, 0.1 + 0.2], lambda x: x)
    0.3
    """
    return ordered(items, lambda item: -value(item))[0]


def _agree(low: float, high: float, least: float) -> bool:
    """Whether two values are one but for round-off; an infinite one agrees with itself alone."""
    larger = max(abs(low), abs(high))
    return low == high or (larger < float("inf") and high - low <= max(AGREE * larger, least))
