"""Springs and dampers of a deck, as figures show them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.sd_orientation import DEFINE_SD_ORIENTATION
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.part import PART
from vmharness.mesh.nodes import Array, Index, Nodes


@dataclass(frozen=True)
class Discrete:
    """Columns over springs and dampers (ne,), in the order of the deck."""

    nodes: Index  # (ne, 2); the second is -1 for the ground
    damper: NDArray[np.bool_]  # else a spring
    direction: Array  # (ne, 3) of the orientation that acts, of length 1; zero without one


NONE = Discrete(np.zeros((0, 2), np.intp), np.zeros(0, bool), np.zeros((0, 3)))


def discrete(deck: Deck, nodes: Nodes) -> Discrete:
    """The springs and dampers; raises DeckError for a node or an orientation that the deck does not have."""
    found = [NONE]
    dampers = list(_dampers(deck))
    for table in deck.all(ELEMENT_DISCRETE):
        ends = nodes.corners(table, table.keyword.corners, ground=True)
        directions = [_direction(deck, nodes, table, row) for row in range(len(ends))]
        found.append(Discrete(ends, np.isin(table.pid, dampers), np.array(directions).reshape(-1, 3)))
    columns = ("nodes", "damper", "direction")
    return Discrete(*(np.concatenate([getattr(part, column) for part in found]) for column in columns))


def _dampers(deck: Deck) -> set[int]:
    """Numbers of the parts whose material is a damper."""
    mids = {entry.mid for entry in deck.entries if entry.keyword.name.startswith("MAT_DAMPER")}
    return {part.pid for part in deck.all(PART) if part.mid in mids}


def _direction(deck: Deck, nodes: Nodes, table: Entry, row: int) -> Array:
    """The vector of *DEFINE_SD_ORIENTATION, or the direction between its nodes."""
    vid = int(table.vid[row])
    if not vid:
        return np.zeros(3)
    entry = deck.find(DEFINE_SD_ORIENTATION, vid=vid, referred_by=(table, "vid", row))
    vector = np.array([entry.xt, entry.yt, entry.zt])
    if entry.nid1 and entry.nid2:
        first, second = (nodes.row(entry, name, getattr(entry, name)) for name in ("nid1", "nid2"))
        vector = nodes.x0[second] - nodes.x0[first]
    return np.asarray(vector / (np.linalg.norm(vector) or 1.0))
