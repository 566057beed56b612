"""Initial velocities of nodes."""

from vmharness.backends.mujoco.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.initial.velocity import INITIAL_VELOCITY, INITIAL_VELOCITY_NODE
from vmharness.deck.rule import only
from vmharness.deck.support import supports
from vmharness.mesh.sets import node_set

ROTATIONS = {f"v{axis}r": only(0.0) for axis in "xyz"}
SUPPORTS = (
    supports(INITIAL_VELOCITY, nsidex=only(0), boxid=only(0), irigid=only(0), icid=only(0), **ROTATIONS),
    supports(INITIAL_VELOCITY_NODE, icid=only(0), **ROTATIONS),
)


def add(deck: Deck, model: Model) -> None:
    """Note the velocity of every node; cards for single nodes overrule those for sets."""
    for entry in deck.all(INITIAL_VELOCITY):
        rows = node_set(deck, model.nodes, entry, "nsid") if entry.nsid else slice(None)
        model.v[rows] = [entry.vx, entry.vy, entry.vz]
    for entry in deck.all(INITIAL_VELOCITY_NODE):
        model.v[model.nodes.row(entry, "nid", entry.nid)] = [entry.vx, entry.vy, entry.vz]
    model.v[model.held] = 0.0
