"""What a deck defines, by kind: curves, sets, parts, nodes, ...; and what is said of a number that is not defined."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, DeckError, Entry, Keyword
from vmharness.deck.keywords.define.curve import DEFINE_CURVE
from vmharness.deck.keywords.define.sd_orientation import DEFINE_SD_ORIENTATION
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.deck.keywords.node import NODE
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.keywords.set.shell import SET_SHELL_LIST, SET_SHELL_LIST_GENERATE
from vmharness.explicit.model.rigid_bodies import body_number, definitions
from vmharness.mesh import sets

LISTED = 10  # numbers of one field that are named each


@dataclass(frozen=True, eq=False)
class Kind:
    """A kind of thing that cards refer to by number, and the keywords that define it."""

    keywords: tuple[Keyword, ...]


CURVE = Kind((DEFINE_CURVE,))
NODES = Kind((NODE,))
SHELLS = Kind((ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS))
PARTS = Kind((PART,))
RIGID_BODIES = Kind(())  # see model/rigid_bodies.py
HOURGLASSES = Kind((HOURGLASS,))
ORIENTATIONS = Kind((DEFINE_SD_ORIENTATION,))
NODE_SETS = Kind(sets.NODE_SETS)
SEGMENT_SETS = Kind((SET_SEGMENT,))
SHELL_SETS = Kind((SET_SHELL_LIST, SET_SHELL_LIST_GENERATE))
PART_SETS = Kind(sets.PART_SETS)
PART_SETS_OF_SURFACES = Kind(sets.PART_SETS)  # every part of these has to be defined


@dataclass
class Defined:
    """The numbers that a deck defines."""

    deck: Deck
    _numbers: dict[Kind, NDArray[np.int64]] = field(default_factory=dict)

    def numbers(self, kind: Kind) -> NDArray[np.int64]:
        """All numbers of a kind."""
        if kind not in self._numbers:
            self._numbers[kind] = _numbers(self.deck, kind)
        return self._numbers[kind]

    def missing(self, entry: Entry, name: str, kind: Kind, zero: bool = False) -> Iterator[DeckError]:
        """An error for each number of a field that is not defined; 0 refers to nothing unless `zero`."""
        values: Any = entry.values.get(name)
        if values is None or (kind is NODES and not self.numbers(NODES).size):
            return
        if not isinstance(values, np.ndarray):
            if (values or zero) and not np.any(self.numbers(kind) == values):
                yield _error(self.deck, entry, name, kind, values)
            return
        rows = np.flatnonzero(~_among(values, self.numbers(kind)))
        rows = rows[values[rows] != 0]
        if not rows.size:
            return
        first = rows[np.sort(np.unique(values[rows], return_index=True)[1])]
        for place, row in enumerate(first[:LISTED].tolist(), 1):
            error = _error(self.deck, entry, name, kind, values[row], row)
            if place == LISTED < first.size:
                error.what += f" ({first.size - LISTED} more are missing)"
            yield error


def distinct(numbers: NDArray[np.int64]) -> NDArray[np.int64]:
    """Each of the numbers once, in increasing order; faster than np.unique where most follow each other so.

    >>> distinct(np.array([2, 2, 5, 2])).tolist()
    [2, 5]
    """
    changes = numbers[np.flatnonzero(np.diff(numbers, prepend=numbers[:1] - 1))]
    return changes if np.all(changes[1:] > changes[:-1]) else np.unique(changes)


def _among(values: NDArray[np.int64], numbers: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which `values` (n,) are among the `numbers` (m,), which increase; faster than np.isin."""
    if not numbers.size:
        return np.zeros(values.size, bool)
    if numbers[-1] - numbers[0] == numbers.size - 1:  # without a gap
        return (values >= numbers[0]) & (values <= numbers[-1])
    return np.asarray(numbers[np.minimum(np.searchsorted(numbers, values), numbers.size - 1)] == values)


def _numbers(deck: Deck, kind: Kind) -> NDArray[np.int64]:
    if kind is RIGID_BODIES:
        return np.array([entry.pid for entry in definitions(deck)], np.int64)
    found = [np.atleast_1d(entry.values.get(entry.keyword.unique, 0)) for entry in deck.all(*kind.keywords)]
    return distinct(np.concatenate([np.zeros(0, np.int64), *found]))


def _error(deck: Deck, entry: Entry, name: str, kind: Kind, number: int, row: int | None = None) -> DeckError:
    """What the builder says, too."""
    if kind in (NODES, SHELLS):
        error = entry.error(name, f"no *{kind.keywords[0].name} {number}", row)
        error.sought = frozenset([kind.keywords[0].name.partition("_")[0]])
        return error
    try:
        if kind is RIGID_BODIES:
            body_number(deck, entry, name)
        else:
            place = (entry, name) if row is None else (entry, name, row)
            deck.find(*kind.keywords, referred_by=place, **{kind.keywords[0].unique: number})
    except DeckError as error:
        error.sought |= {"MAT", "PART"} if kind is RIGID_BODIES else set()
        return error
    raise AssertionError(f"{name} = {number} is defined")
