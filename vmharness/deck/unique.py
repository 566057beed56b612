"""What is defined, is defined once."""

from collections.abc import Sequence

import numpy as np

from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError


def first_of_single(entries: Sequence[Entry], wrong: list[DeckError]) -> list[Entry]:
    """The entries without the second ones of keywords that may stand only once, which are added to `wrong`."""
    first: dict[str, Entry] = {}
    kept = []
    for entry in entries:
        other = first.setdefault(entry.keyword.name, entry) if entry.keyword.single else entry
        if other is entry:
            kept.append(entry)
        else:
            what = f"may stand only once; there is one already at {other.file}:{other.line}"
            wrong.append(entry.error(None, what))
    return kept


def repeated(entries: Sequence[Entry]) -> list[DeckError]:
    """Of each kind of id, the first that is defined a second time."""
    kinds: dict[str, list[Entry]] = {}
    for entry in entries:
        if entry.keyword.unique and entry.keyword.unique in entry.values:
            kinds.setdefault(entry.keyword.kind, []).append(entry)
    return [error for members in kinds.values() for error in _repeated_id(members)]


def _repeated_id(entries: Sequence[Entry]) -> list[DeckError]:
    """The first second definition of an id among ids of one kind, of tables and single cards alike; 0 is no id."""
    groups = [np.atleast_1d(entry.values[entry.keyword.unique]) for entry in entries]
    ids = np.concatenate(groups)
    order = np.argsort(ids, kind="stable")
    same = np.flatnonzero((ids[order][1:] == ids[order][:-1]) & (ids[order][1:] != 0))
    if not same.size:
        return []
    again = same[np.argmin(order[same + 1])]  # the first in the deck
    first, second = (_place(entries, groups, int(order[again + i])) for i in (0, 1))
    (entry, row), (other, other_row) = second, first
    line = other.line_of(other.keyword.unique, other_row)
    return [entry.error(entry.keyword.unique, f"defined already at {other.file}:{line}", row)]


def _place(entries: Sequence[Entry], groups: Sequence[np.ndarray], index: int) -> tuple[Entry, int | None]:
    """Entry and row (None for a single card) of the id at `index` among all."""
    for entry, group in zip(entries, groups, strict=True):
        if index < len(group):
            return entry, index if entry.keyword.rows and np.ndim(
                entry.values[entry.keyword.unique]
            ) else None
        index -= len(group)
    raise IndexError(index)
