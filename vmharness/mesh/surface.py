"""Contact surfaces of a deck: the segments and nodes that SURFA, SURFB and their types name.

    0 segment set   1 shell set   2 part set   3 part   4 node set   5 all   6 all but a part set

A face that two solids of one surface share is not on its outside, and no part of it.
"""

from dataclasses import dataclass, fields
from typing import Self

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
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.set.part import SET_PART_LIST
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.keywords.set.shell import SET_SHELL_LIST, SET_SHELL_LIST_GENERATE
from vmharness.mesh.elements import by_part, elements, shells
from vmharness.mesh.faces import faces_of_solids, outside
from vmharness.mesh.nodes import Index, Nodes
from vmharness.mesh.sets import PART_SETS, in_ranges, node_set, part_set

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

    def only(self, chosen: NDArray[np.bool_] | Index) -> Self:
        """The chosen ones."""
        return type(self)(*(getattr(self, column.name)[chosen] for column in fields(self)))


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


def exterior(faces: Faces) -> NDArray[np.bool_]:
    """Which faces (n,) can be touched: all shells, and those of solids that one of the solids alone has."""
    touchable = faces.shell.copy()
    touchable[~faces.shell] = outside(faces.nodes[~faces.shell])
    return touchable


def segments(deck: Deck, nodes: Nodes, every: Faces, contact: Entry, side: str) -> Index:
    """The segments (ns, 4) of side "a" or "b" of a contact, among `every` face of the deck."""
    field, kind = _named(contact, side)
    if kind == SEGMENT_SET:
        found = deck.find(SET_SEGMENT, sid=getattr(contact, field), referred_by=(contact, field))
        return nodes.corners(found, ("n1", "n2", "n3", "n4"))
    chosen = every.only(named_faces(deck, every, contact, field, kind))
    return chosen.nodes[exterior(chosen)]


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


def named_faces(deck: Deck, every: Faces, contact: Entry, field: str, kind: int) -> NDArray[np.bool_]:
    """Which faces (n,) belong to the parts or shells that `field` names, those between solids included.

    Raises DeckError where it names a part or a shell that the deck does not have.
    """
    number = getattr(contact, field)
    if kind == ALL:
        return np.ones(every.pid.size, bool)
    if kind == SHELL_SET:
        named = deck.find(SET_SHELL_LIST, SET_SHELL_LIST_GENERATE, sid=number, referred_by=(contact, field))
        if named.keyword is SET_SHELL_LIST_GENERATE:
            return every.shell & in_ranges(named, every.eid)
        for row in np.flatnonzero(~np.isin(named.shells, every.eid[every.shell])):
            raise named.error("shells", f"no *ELEMENT_SHELL {named.shells[row]}", int(row))
        return every.shell & np.isin(every.eid, named.shells)
    if kind == ONE_PART:
        deck.find(PART, pid=number, referred_by=(contact, field))
        return every.pid == number
    return np.isin(every.pid, defined_parts(deck, contact, field), invert=kind == EXEMPT)


def defined_parts(deck: Deck, contact: Entry, field: str) -> list[int]:
    """The parts of the part set that `field` names; raises DeckError for one that the deck does not have."""
    found = deck.find(*PART_SETS, sid=getattr(contact, field), referred_by=(contact, field))
    if found.keyword is SET_PART_LIST:
        for row, number in enumerate(found.parts.tolist()):
            deck.find(PART, pid=number, referred_by=(found, "parts", row))
    return sorted(part_set(deck, contact, field))
