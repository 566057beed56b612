"""*INITIAL_VELOCITY, *INITIAL_VELOCITY_NODE and *INITIAL_VELOCITY_GENERATION: velocities of nodes at t = 0.

*INITIAL_VELOCITY_GENERATION gives a rigid motion,

    v = V + OMEGA n x (x - c)        omega = OMEGA n

with the axis through c = (XC, YC, ZC) along the unit vector n of (NX, NY, NZ). ID 0 is all nodes; otherwise STYP says
what ID numbers: 1 a part set, 2 a part, 3 a node set.

A later card overrules an earlier one, and *INITIAL_VELOCITY_NODE overrules sets.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.initial.velocity import INITIAL_VELOCITY, INITIAL_VELOCITY_NODE
from vmharness.deck.keywords.initial.velocity_generation import INITIAL_VELOCITY_GENERATION
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import among, anything, at_least, only, where
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index
from vmharness.mesh.sets import node_set, nodes_of_parts, part_set

AXIS = ("xc", "yc", "zc", "nx", "ny", "nz")

SUPPORTS = (
    supports(INITIAL_VELOCITY, boxid=only(0), irigid=only(0), icid=only(0)),
    supports(INITIAL_VELOCITY_NODE, icid=only(0)),
    supports(
        INITIAL_VELOCITY_GENERATION,
        id=at_least(0),
        styp=among(1, 2, 3, idle=where(lambda entry: entry.id == 0, "ID = 0 is all nodes")),
        **{name: anything(where(lambda entry: not entry.omega, "no rotation")) for name in AXIS},
        ivatn=only(0),
        icid=only(0),
        phase=only(0),
        irigid=only(0),
    ),
)

PART_SET, NODE_SET = 1, 3  # STYP


def build(deck: Deck, model: Model) -> None:
    """Set v and omega of the nodes that each card names."""
    _set_velocities(deck, model)
    _generate_velocities(deck, model)


def _set_velocities(deck: Deck, model: Model) -> None:
    for entry in deck.all(INITIAL_VELOCITY):
        rows = node_set(deck, model, entry, "nsid") if entry.nsid else slice(None)
        _set(model, rows, entry, "")
        if entry.nsidex:
            _set(model, node_set(deck, model, entry, "nsidex"), entry, "e")
    for entry in deck.all(INITIAL_VELOCITY_NODE):
        _set(model, model.row(entry, "nid", entry.nid), entry, "")


def _set(model: Model, rows: Index | slice | int, entry: Entry, suffix: str) -> None:
    model.state.v[rows] = np.array([getattr(entry, f"v{axis}{suffix}") for axis in "xyz"])
    model.state.omega[rows] = np.array([getattr(entry, f"v{axis}r{suffix}") for axis in "xyz"])


def _generate_velocities(deck: Deck, model: Model) -> None:
    for entry in deck.all(INITIAL_VELOCITY_GENERATION):
        for other in deck.all(INITIAL_VELOCITY, INITIAL_VELOCITY_NODE):
            raise entry.error(
                "id",
                f"not supported together with {other.keyword}: LS-DYNA does not define which one applies",
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
        rows = nodes_of_parts(deck, model, part_set(deck, entry, "id"))
    else:
        deck.find(PART, pid=entry.id, referred_by=(entry, "id"))
        rows = nodes_of_parts(deck, model, {entry.id})
    if not rows.size:
        raise entry.error("id", "names no node: no element belongs to it")
    return rows


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
