"""Initial velocities of nodes."""

from collections.abc import Iterator

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.initial.velocity import INITIAL_VELOCITY, INITIAL_VELOCITY_NODE
from vmharness.deck.rule import only
from vmharness.deck.support import supports
from vmharness.mesh.nodes import Array, Index, Nodes
from vmharness.mesh.sets import node_set

ROTATIONS = {f"v{axis}r": only(0.0) for axis in "xyz"}
SUPPORTS = (
    supports(INITIAL_VELOCITY, nsidex=only(0), boxid=only(0), irigid=only(0), icid=only(0), **ROTATIONS),
    supports(INITIAL_VELOCITY_NODE, icid=only(0), **ROTATIONS),
)


def initial_velocities(deck: Deck, nodes: Nodes) -> Iterator[tuple[Entry, Index, Array]]:
    """Yield each card, rows (m,) of its nodes and their velocity (3,); later ones overrule, single nodes sets."""
    for entry in deck.all(INITIAL_VELOCITY):
        yield (
            entry,
            node_set(deck, nodes, entry, "nsid") if entry.nsid else np.arange(nodes.ids.size),
            _v(entry),
        )
    for entry in deck.all(INITIAL_VELOCITY_NODE):
        yield entry, np.array([nodes.row(entry, "nid", entry.nid)]), _v(entry)


def _v(entry: Entry) -> Array:
    return np.array([entry.vx, entry.vy, entry.vz])
