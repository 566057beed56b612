"""What is defined, is defined once."""

from collections.abc import Sequence

import numpy as np

from vmharness.deck.entry import Entry


def check_unique(entries: Sequence[Entry]) -> None:
    """Raise DeckError for a second entry of a single keyword and for a second definition of an id."""
    kinds: dict[str, list[Entry]] = {}
    single: dict[str, Entry] = {}
    for entry in entries:
        keyword = entry.keyword
        if keyword.unique:
            kinds.setdefault(keyword.kind, []).append(entry)
        if keyword.single and (other := single.setdefault(keyword.name, entry)) is not entry:
            raise entry.error(None, f"may stand only once; there is one already at {other.file}:{other.line}")
    for members in kinds.values():
        _check_ids(members)


def _check_ids(entries: Sequence[Entry]) -> None:
    """Ids of one kind, of tables and single cards alike; 0 is no id."""
    groups = [np.atleast_1d(entry.values[entry.keyword.unique]) for entry in entries]
    ids = np.concatenate(groups)
    order = np.argsort(ids, kind="stable")
    same = np.flatnonzero((ids[order][1:] == ids[order][:-1]) & (ids[order][1:] != 0))
    if not same.size:
        return
    again = same[np.argmin(order[same + 1])]  # the first in the deck
    first, second = (_place(entries, groups, int(order[again + i])) for i in (0, 1))
    (entry, row), (other, other_row) = second, first
    line = other.line_of(other.keyword.unique, other_row)
    raise entry.error(entry.keyword.unique, f"defined already at {other.file}:{line}", row)


def _place(entries: Sequence[Entry], groups: Sequence[np.ndarray], index: int) -> tuple[Entry, int | None]:
    """Entry and row (None for a single card) of the id at `index` among all."""
    for entry, group in zip(entries, groups, strict=True):
        if index < len(group):
            return entry, index if entry.keyword.rows and np.ndim(
                entry.values[entry.keyword.unique]
            ) else None
        index -= len(group)
    raise IndexError(index)
