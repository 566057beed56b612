"""The nodes of a deck: rows of arrays, found by number."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, DeckError, Entry
from vmharness.deck.keywords.node import NODE

Array = NDArray[np.float64]
Index = NDArray[np.intp]


@dataclass
class Nodes:
    """Numbers and initial coordinates of the nodes, in the order of the deck."""

    ids: NDArray[np.int64]  # (n,)
    x0: Array  # (n, 3)

    @cached_property
    def order(self) -> Index:
        """Rows (n,) in the order of their numbers."""
        return np.argsort(self.ids)

    @property
    def node_count(self) -> int:
        """How many rows are nodes of the deck."""
        return int(np.count_nonzero(self.ids > 0))

    def find(self, entry: Entry, name: str, ids: NDArray[np.int64], ground: bool = False) -> Index:
        """Rows (m,) of the nodes `ids`, a column of `entry`; raises DeckError at the first that is no node.

        With `ground`, the number 0 is no node but the ground: row -1.
        """
        rows = np.where(ground & (ids == 0), -1, self._nearest(ids))
        for index in np.flatnonzero(((self.ids[rows] != ids) | (ids < 0)) & (rows >= 0)):
            raise entry.error(name, f"no *NODE {ids[index]}", int(index))
        return rows

    def corners(self, table: Entry, names: Sequence[str], ground: bool = False) -> Index:
        """Rows (m, corners) of the nodes that the columns `names` of a table give; see `find`."""
        return np.column_stack([self.find(table, name, getattr(table, name), ground) for name in names])

    def row(self, entry: Entry, name: str, nid: int, index: int | None = None) -> int:
        """The row of node `nid`; raises DeckError naming the card and field that refer to it."""
        row = int(self._nearest(nid))
        if self.ids[row] != nid or nid < 0:
            raise entry.error(name, f"no *NODE {nid}", index)
        return row

    def _nearest(self, ids: NDArray[np.int64] | int) -> Index:
        """Rows of `ids` where they are nodes, else of some other node."""
        place = np.searchsorted(self.ids, ids, sorter=self.order)
        return np.asarray(self.order[np.minimum(place, self.ids.size - 1)])


def nodes_of(deck: Deck) -> Nodes:
    """All nodes of the deck; raises DeckError where it has none."""
    tables = deck.all(NODE)
    if not tables:
        raise DeckError("no *NODE in the deck", str(deck.path.name), 1)
    x = [np.column_stack([table.x, table.y, table.z]) for table in tables]
    return Nodes(np.concatenate([table.nid for table in tables]), np.concatenate(x))
