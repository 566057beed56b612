"""Initial velocities of nodes and rigid bodies, as figures show them."""

from collections.abc import Iterable, Iterator

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.initial.velocity import INITIAL_VELOCITY, INITIAL_VELOCITY_NODE
from vmharness.deck.keywords.initial.velocity_generation import INITIAL_VELOCITY_GENERATION
from vmharness.mesh.bodies import Body
from vmharness.mesh.loads import Arrows
from vmharness.mesh.nodes import Array, Index, Nodes
from vmharness.mesh.sets import node_set, nodes_of_parts, part_set

PART_SET, NODE_SET = 1, 3  # STYP
FEW, SEVERAL = 16, 3  # nodes of one velocity: few have an arrow each, more have several together


def velocities(deck: Deck, nodes: Nodes, bodies: Iterable[Body]) -> dict[str, Arrows]:
    """Places and directions of the initial velocities and angular velocities that are not zero.

    A body with a velocity of its own has arrows at its centre. Of many nodes of one velocity some have an arrow.
    """
    bodies = list(bodies)
    v = _of_nodes(deck, nodes)
    linear, spin = [], []
    for body in bodies:
        if body.motion is not None:
            v[body.nodes] = 0.0
            at = nodes.x0[body.nodes].mean(axis=0) if body.centre is None else body.centre
            linear.append((at, body.motion[0]))
            spin.append((at, body.motion[1]))
    linear += [(nodes.x0[row], v[row]) for row in _chosen(v)]
    found = {"initial velocity": _arrows(linear), "initial spin": _arrows(spin)}
    return {what: arrows for what, arrows in found.items() if len(arrows[0])}


def _chosen(v: Array) -> Iterator[int]:
    """Rows of some nodes of each velocity that is not zero, in the order of the deck."""
    values, group = np.unique(v, axis=0, return_inverse=True)
    for number in np.flatnonzero(values.any(axis=1)):
        rows = np.flatnonzero(group.ravel() == number)
        count = rows.size if rows.size <= FEW else SEVERAL
        yield from rows[np.linspace(0, rows.size - 1, count).round().astype(int)].tolist()


def _arrows(found: list[tuple[Array, Array]]) -> Arrows:
    """Places and directions (n, 3) of the vectors with a length."""
    moving = [(at, along / np.linalg.norm(along)) for at, along in found if along.any()]
    places, directions = (np.array([pair[k] for pair in moving]).reshape(-1, 3) for k in (0, 1))
    return places, directions


def _of_nodes(deck: Deck, nodes: Nodes) -> Array:
    """The velocity (n, 3) that cards give to each node; a later card overrules an earlier one."""
    v = np.zeros((nodes.ids.size, 3))
    for entry in deck.all(INITIAL_VELOCITY_GENERATION):
        rows, axis = _named(deck, nodes, entry), np.array([entry.nx, entry.ny, entry.nz])
        arm = nodes.x0[rows] - np.array([entry.xc, entry.yc, entry.zc])
        spin = entry.omega * axis / (np.linalg.norm(axis) or 1.0)
        v[rows] = np.array([entry.vx, entry.vy, entry.vz]) + np.cross(spin, arm)
    for entry in deck.all(INITIAL_VELOCITY):
        rows = node_set(deck, nodes, entry, "nsid") if entry.nsid else np.arange(nodes.ids.size)
        v[rows] = [entry.vx, entry.vy, entry.vz]
        if entry.nsidex:
            v[node_set(deck, nodes, entry, "nsidex")] = [entry.vxe, entry.vye, entry.vze]
    for entry in deck.all(INITIAL_VELOCITY_NODE):
        v[nodes.row(entry, "nid", entry.nid)] = [entry.vx, entry.vy, entry.vz]
    return v


def _named(deck: Deck, nodes: Nodes, entry: Entry) -> Index:
    """The nodes of *INITIAL_VELOCITY_GENERATION: all, or those of a part set, a part, a node set."""
    if entry.id == 0:
        return np.arange(nodes.ids.size)
    if entry.styp == NODE_SET:
        return node_set(deck, nodes, entry, "id")
    return nodes_of_parts(deck, nodes, part_set(deck, entry, "id") if entry.styp == PART_SET else {entry.id})
