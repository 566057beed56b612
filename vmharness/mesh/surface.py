"""Contact surfaces of a deck: the segments and nodes that SURFA, SURFB and their types name.

    0 segment set   1 shell set   2 part set   3 part   4 node set   5 all   6 all but a part set

A face that two solids of one surface share is not on its outside, and no part of it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.contact import (
    CONTACT_AUTOMATIC_NODES_TO_SURFACE,
    CONTACT_AUTOMATIC_SINGLE_SURFACE,
    CONTACT_AUTOMATIC_SURFACE_TO_SURFACE,
    CONTACT_NODES_TO_SURFACE,
    CONTACT_ONE_WAY_SURFACE_TO_SURFACE,
    CONTACT_SURFACE_TO_SURFACE,
)
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.keywords.set.shell import SET_SHELL_LIST
from vmharness.mesh.elements import by_part, elements, shells
from vmharness.mesh.faces import faces_of_solids, outside
from vmharness.mesh.nodes import Index, Nodes
from vmharness.mesh.sets import node_set, part_set

SEGMENT_SET, SHELL_SET, PART_SET, ONE_PART, NODE_SET, ALL, EXEMPT = range(7)

CONTACTS = (
    CONTACT_AUTOMATIC_NODES_TO_SURFACE,
    CONTACT_AUTOMATIC_SINGLE_SURFACE,
    CONTACT_AUTOMATIC_SURFACE_TO_SURFACE,
    CONTACT_NODES_TO_SURFACE,
    CONTACT_ONE_WAY_SURFACE_TO_SURFACE,
    CONTACT_SURFACE_TO_SURFACE,
)
SINGLE = CONTACT_AUTOMATIC_SINGLE_SURFACE  # side A against itself
TWO_WAY = (CONTACT_AUTOMATIC_SURFACE_TO_SURFACE, CONTACT_SURFACE_TO_SURFACE)  # A against B, then B against A


@dataclass(frozen=True)
class Faces:
    """Columns over faces (n,): every shell, and every face of every solid."""

    nodes: Index  # (n, 4) rows; a triangle's third comes twice
    shell: NDArray[np.bool_]
    pid: NDArray[np.int64]  # of the part
    eid: NDArray[np.int64]  # of the element


def all_faces(deck: Deck, nodes: Nodes) -> Faces:
    """The faces of all shells and solids, also where two solids share one."""
    shell, solid = shells(deck, nodes), by_part(elements(deck, nodes, 8, ELEMENT_SOLID))
    faces, owner = faces_of_solids(solid.nodes)
    return Faces(
        np.concatenate([shell.nodes, faces]),
        np.repeat([True, False], [len(shell.eid), len(faces)]),
        np.concatenate([shell.pid, solid.pid[owner]]),
        np.concatenate([shell.eid, solid.eid[owner]]),
    )


def segments(deck: Deck, nodes: Nodes, every: Faces, contact: Entry, side: str) -> Index:
    """The segments (ns, 4) of side "a" or "b" of a contact, among `every` face of the deck."""
    field, kind = _named(contact, side)
    if kind == SEGMENT_SET:
        found = deck.find(SET_SEGMENT, sid=getattr(contact, field), referred_by=(contact, field))
        return nodes.corners(found, ("n1", "n2", "n3", "n4"))
    chosen = np.flatnonzero(_chosen(deck, every, contact, field, kind))
    inner = ~every.shell[chosen]
    inner[inner] = ~outside(every.nodes[chosen[inner]])
    return every.nodes[chosen[~inner]]


def surface_nodes(deck: Deck, nodes: Nodes, every: Faces, contact: Entry, side: str) -> Index:
    """Rows (m,) of the nodes of a side, each once, in increasing order: of a node set, or of its segments."""
    field, kind = _named(contact, side)
    if kind == NODE_SET:
        return node_set(deck, nodes, contact, field)
    return np.unique(segments(deck, nodes, every, contact, side))


def _named(contact: Entry, side: str) -> tuple[str, int]:
    """The field that names the surface, and its type; a single surface without a name is all of the deck."""
    field = f"surf{side}"
    single = contact.keyword is SINGLE and getattr(contact, field) == 0
    return field, ALL if single else getattr(contact, f"{field}typ")


def _chosen(deck: Deck, every: Faces, contact: Entry, field: str, kind: int) -> NDArray[np.bool_]:
    """Which faces belong to the parts or shells that are named, those between solids included."""
    number = getattr(contact, field)
    if kind == ALL:
        return np.ones(every.pid.size, bool)
    if kind == SHELL_SET:
        named = deck.find(SET_SHELL_LIST, sid=number, referred_by=(contact, field))
        return every.shell & np.isin(every.eid, named.shells)
    if kind == ONE_PART:
        return every.pid == number
    return np.isin(every.pid, list(part_set(deck, contact, field)), invert=kind == EXEMPT)
