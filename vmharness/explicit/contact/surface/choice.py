"""Which faces and nodes a contact surface has: SURFATYP and SURFBTYP (mesh/surface.py).

A segment of a set takes stiffness and thickness from the shell, or else the solid, that has the same corners. Beams
have no faces: 5 and 6 refuse a deck in which they would be part of the surface.
"""

from dataclasses import replace

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.explicit.contact.surface.faces import ContactFaces
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index
from vmharness.mesh.faces import area_vectors, corner_sets
from vmharness.mesh.sets import node_set
from vmharness.mesh.surface import (
    ALL,
    EXEMPT,
    NODE_SET,
    PART_SET,
    SEGMENT_SET,
    defined_parts,
    exterior,
    named_faces,
)

ROUND_OFF = 1e-9  # of the segments' size: nodes that lie in the surface are not behind it


def faces_of_surface(
    deck: Deck, model: Model, every: ContactFaces, entry: Entry, field: str, kind: int
) -> ContactFaces:
    """The faces of the surface that `field` of `entry` names, among `every` of the deck.

    Raises DeckError for what is not defined, and for a surface without faces.
    """
    if kind == SEGMENT_SET:
        return _segment_set(deck, model, every, entry, field)
    _check_parts(deck, every, entry, field, kind)
    chosen = every.only(named_faces(deck, every, entry, field, kind))
    if not chosen.pid.size:
        raise entry.error(field, "the surface has neither shells nor solids")
    return chosen.only(exterior(chosen))


def nodes_of_surface(
    deck: Deck, model: Model, every: ContactFaces, entry: Entry, field: str, kind: int
) -> Index:
    """Rows (m,) of the nodes of a surface, each once, in increasing order: of a node set, or of its faces."""
    if kind == NODE_SET:
        return node_set(deck, model, entry, field)
    return np.unique(faces_of_surface(deck, model, every, entry, field, kind).nodes)


def _check_parts(deck: Deck, every: ContactFaces, entry: Entry, field: str, kind: int) -> None:
    """Parts that are named have faces, and none that the surface takes in is beams."""
    if kind == ALL:
        _check_beams(deck, entry, field, [])
    elif kind in (PART_SET, EXEMPT):
        parts = defined_parts(deck, entry, field)
        if kind == EXEMPT:
            _check_beams(deck, entry, field, parts)
        elif bare := sorted(set(parts) - set(every.pid.tolist())):
            raise entry.error(field, f"part {bare[0]} of the set has neither shells nor solids")


def _check_beams(deck: Deck, entry: Entry, field: str, exempt: list[int]) -> None:
    """All that the deck has, but for parts that are exempt, is shells and solids, or has no surface."""
    for table in deck.all(ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION):
        for pid in table.pid[~np.isin(table.pid, exempt)][:1]:
            what = f"part {pid} is beams, whose contact is not supported; name the parts without them, by a part set"
            raise entry.error(field, what)


def _segment_set(deck: Deck, model: Model, every: ContactFaces, entry: Entry, field: str) -> ContactFaces:
    """The segments as given, their corners in the order that the set has them."""
    found = deck.find(SET_SEGMENT, sid=getattr(entry, field), referred_by=(entry, field))
    nodes = model.corners(found, ("n1", "n2", "n3", "n4"))
    keys = corner_sets(np.concatenate([nodes, every.nodes]))
    _, place = np.unique(keys, axis=0, return_inverse=True)
    wanted, there = np.split(place.ravel(), [nodes.shape[0]])
    # Of faces with the same corners the last in this order is taken: shells before solids, stiff before soft ones.
    order = np.lexsort([every.penalty, every.shell])
    face = np.full(place.max(initial=-1) + 1, -1)
    face[there[order]] = order
    for row in np.flatnonzero(face[wanted] < 0).tolist():
        raise found.error("n1", "no shell and no face of a solid has the nodes of this segment", row)
    return replace(every.only(face[wanted]), nodes=nodes)


def lies_behind(segments: Index, x: Array, tracked: Index) -> bool:
    """Whether the tracked nodes (nt,) lie, on the whole, behind the segments (ns, 4).

    The sign of sum A n . (mean of the tracked nodes - centre of the segment).
    """
    centre, areas = x[segments].mean(axis=1), area_vectors(x[segments])
    side = np.einsum("ij,ij->", x[tracked].mean(axis=0) - centre, areas)
    return bool(side < -ROUND_OFF * (np.linalg.norm(areas, axis=1) ** 1.5).sum())


def reverse(segments: Index) -> Index:
    """The segments (ns, 4) with their normals reversed; a triangle's third corner stays the one that comes twice.

    >>> reverse(np.array([[1, 2, 3, 4], [1, 2, 3, 3]])).tolist()
    [[4, 3, 2, 1], [2, 1, 3, 3]]
    """
    triangle = segments[:, 2] == segments[:, 3]
    return np.where(triangle[:, None], segments[:, [1, 0, 2, 3]], segments[:, ::-1])
