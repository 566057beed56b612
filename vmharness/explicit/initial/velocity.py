"""*INITIAL_VELOCITY and *INITIAL_VELOCITY_NODE: velocities at t = 0."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Card, Deck, Entry, Keyword
from vmharness.deck.field import integer, only, real
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.sets import node_set

INITIAL_VELOCITY = Keyword(
    "INITIAL_VELOCITY",
    Card(nsid=integer(0), nsidex=integer(0), boxid=only(0), irigid=only(0), icid=only(0)),
    Card(vx=real(0.0), vy=real(0.0), vz=real(0.0), vxr=real(0.0), vyr=real(0.0), vzr=real(0.0)),
    Card(
        vxe=real(0.0),
        vye=real(0.0),
        vze=real(0.0),
        vxre=real(0.0),
        vyre=real(0.0),
        vzre=real(0.0),
        when=lambda entry: entry.nsidex > 0,
    ),
)
INITIAL_VELOCITY_NODE = Keyword(
    "INITIAL_VELOCITY_NODE",
    Card(
        nid=integer(),
        vx=real(0.0),
        vy=real(0.0),
        vz=real(0.0),
        vxr=real(0.0),
        vyr=real(0.0),
        vzr=real(0.0),
        icid=only(0),
    ),
    repeat=True,
)


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
