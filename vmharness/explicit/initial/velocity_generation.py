"""*INITIAL_VELOCITY_GENERATION: a rigid motion as initial velocities.

    v = V + OMEGA n x (x - c)        omega = OMEGA n

with the axis through c = (XC, YC, ZC) along the unit vector n of (NX, NY, NZ). ID 0 is all nodes; otherwise STYP says
what it numbers: 1 a part set, 2 a part, 3 a node set. Where two cards meet the later wins.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.initial.velocity import INITIAL_VELOCITY, INITIAL_VELOCITY_NODE
from vmharness.deck.keywords.initial.velocity_generation import INITIAL_VELOCITY_GENERATION
from vmharness.deck.keywords.part import PART
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.mesh.sets import node_set, nodes_of_parts, part_set

Index = NDArray[np.intp]

PART_SET, NODE_SET = 1, 3  # STYP


def build(deck: Deck, model: Model) -> None:
    """Set v and omega of the nodes that each card names."""
    for entry in deck.all(INITIAL_VELOCITY_GENERATION):
        for other in deck.all(INITIAL_VELOCITY, INITIAL_VELOCITY_NODE):
            raise entry.error(
                "id", f"not supported beside {other.keyword}: which of them wins is not certain"
            )
        nodes, spin = _nodes(deck, model, entry), _spin(entry)
        arm = model.x0[nodes] - np.array([entry.xc, entry.yc, entry.zc])
        model.state.v[nodes] = np.array([entry.vx, entry.vy, entry.vz]) + np.cross(spin, arm)
        model.state.omega[nodes] = spin


def _nodes(deck: Deck, model: Model, entry: Entry) -> Index:
    if entry.id == 0:
        return np.arange(model.ids.size)
    if entry.styp == NODE_SET:
        return node_set(deck, model, entry, "id")
    if entry.styp == PART_SET:
        return nodes_of_parts(deck, model, part_set(deck, entry, "id"))
    deck.find(PART, pid=entry.id, referred_by=(entry, "id"))
    return nodes_of_parts(deck, model, {entry.id})


def _spin(entry: Entry) -> Array:
    """OMEGA n."""
    n = np.array([entry.nx, entry.ny, entry.nz])
    if entry.nx == -999.0:
        raise entry.error("nx", "an axis through two nodes is not supported; give its direction")
    if not n.any():
        if entry.omega != 0.0:
            raise entry.error("omega", "a rotation needs an axis: NX, NY, NZ")
        return n
    return np.asarray(entry.omega * n / np.linalg.norm(n))
