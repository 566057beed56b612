"""*INITIAL_VELOCITY and *INITIAL_VELOCITY_NODE: velocities at t = 0."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.initial.velocity import INITIAL_VELOCITY, INITIAL_VELOCITY_NODE
from vmharness.explicit.model.model import Model
from vmharness.mesh.sets import node_set


def build(deck: Deck, model: Model) -> None:
    """Set v and omega; a later card overrides an earlier one, and _NODE overrides sets."""
    for entry in deck.all(INITIAL_VELOCITY):
        rows = node_set(deck, model, entry, "nsid") if entry.nsid else slice(None)
        _set(model, rows, entry, "")
        if entry.nsidex:
            _set(model, node_set(deck, model, entry, "nsidex"), entry, "e")
    for entry in deck.all(INITIAL_VELOCITY_NODE):
        _set(model, model.row(entry, "nid", entry.nid), entry, "")


def _set(model: Model, rows: NDArray[np.intp] | slice | int, entry: Entry, suffix: str) -> None:
    model.state.v[rows] = np.array([getattr(entry, f"v{axis}{suffix}") for axis in "xyz"])
    model.state.omega[rows] = np.array([getattr(entry, f"v{axis}r{suffix}") for axis in "xyz"])
