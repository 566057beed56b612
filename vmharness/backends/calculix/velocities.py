"""Initial velocities of nodes, except those of elements that CalculiX expands to solids: they do not get them."""

import numpy as np

from vmharness.backends.calculix.model import Lines, Model, real
from vmharness.deck import Deck, Entry
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
        every = np.arange(model.nodes.ids.size)
        _set(model, entry, node_set(deck, model.nodes, entry, "nsid") if entry.nsid else every)
    for entry in deck.all(INITIAL_VELOCITY_NODE):
        _set(model, entry, np.array([model.nodes.row(entry, "nid", entry.nid)]))


def _set(model: Model, entry: Entry, rows: np.ndarray) -> None:
    velocity = np.array([entry.vx, entry.vy, entry.vz])
    if velocity.any() and model.expanded[rows].any():
        what = "calculix: initial velocities do not reach the solids to which it expands trusses, beams and shells"
        raise entry.error(None, what)
    model.velocities[rows] = velocity


def lines(model: Model) -> Lines:
    """*INITIAL CONDITIONS of all nodes that move."""
    moving = np.argwhere((model.velocities != 0.0) & model.used[:, None]).tolist()
    values = [f"{row + 1},{axis + 1},{real(float(model.velocities[row, axis]))}" for row, axis in moving]
    return ["*INITIAL CONDITIONS,TYPE=VELOCITY", *values] if values else []
