"""Contact surfaces: nodes and segments, from sets, parts and segment sets of the deck."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.set_segment import SET_SEGMENT
from vmharness.explicit.model import Model
from vmharness.explicit.parts import Part
from vmharness.explicit.sets import node_set, part_set
from vmharness.explicit.shells import shell_parts
from vmharness.explicit.state import Array

Index = NDArray[np.intp]

QUADRILATERALS = "only shells of four nodes are supported in contact"


@dataclass(frozen=True)
class Segments:
    """Quadrilaterals that can be touched."""

    nodes: Index  # (ns, 4) rows of the state's arrays
    penalty: Array  # (ns,) K A / d, the stiffness before scale factors


def nodes_of_surface(deck: Deck, model: Model, entry: Entry, field: str, kind: int) -> Index:
    """Rows of the nodes of a surface: kind 4 node set, 3 part, 2 part set."""
    if kind == 4:
        return node_set(deck, model, entry, field)
    return np.unique(
        np.concatenate([part.nodes.ravel() for part in _chosen(deck, model, entry, field, kind)])
    )


def segments_of_surface(deck: Deck, model: Model, entry: Entry, field: str, kind: int) -> Segments:
    """The shells of a part (kind 3) or part set (2) as segments, or those of a segment set (0)."""
    if kind == 0:
        return _segment_set(deck, model, entry, field)
    parts = _chosen(deck, model, entry, field, kind)
    return Segments(
        np.concatenate([part.nodes for part in parts]),
        np.concatenate([penalty(part, model) for part in parts]),
    )


def penalty(part: Part, model: Model) -> Array:
    """K A / d (ne,) of the shells of a part: bulk modulus, area, longer diagonal."""
    corners = model.x0[part.nodes]
    first, second = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    area = 0.5 * np.linalg.norm(np.cross(first, second), axis=1)
    diagonal = np.maximum(np.linalg.norm(first, axis=1), np.linalg.norm(second, axis=1))
    bulk = part.material.e / (3.0 * (1.0 - 2.0 * part.material.pr))
    return np.asarray(bulk * area / diagonal)


def penalty_at_nodes(deck: Deck, model: Model, entry: Entry, field: str, tracked: Index) -> Array:
    """The largest K A / d (nt,) of the shells at each tracked node; infinite where it has none.

    Raises DeckError at `field` of the contact `entry` for a node of a triangle.
    """
    for part in shell_parts(deck, model, corners=3):
        for row in tracked[np.isin(tracked, part.nodes)]:
            raise entry.error(field, f"node {model.ids[row]} is one of a triangle; {QUADRILATERALS}")
    largest = np.zeros(model.ids.size)
    for part in shell_parts(deck, model, corners=4):
        np.maximum.at(largest, part.nodes, penalty(part, model)[:, None])
    return np.where(largest[tracked] > 0.0, largest[tracked], np.inf)


def _chosen(deck: Deck, model: Model, entry: Entry, field: str, kind: int) -> list[Part]:
    number = getattr(entry, field)
    if kind == 3:
        deck.find(PART, pid=number, referred_by=(entry, field))
        pids = {number}
    else:
        pids = part_set(deck, entry, field)
    for part in shell_parts(deck, model, corners=3):
        if part.pid in pids:
            raise entry.error(field, f"part {part.pid} has triangles; {QUADRILATERALS}")
    parts = [part for part in shell_parts(deck, model, corners=4) if part.pid in pids]
    if not parts:
        raise entry.error(field, "the surface has no shells; only shells are supported")
    return parts


def _segment_set(deck: Deck, model: Model, entry: Entry, field: str) -> Segments:
    """Each segment takes its stiffness from the shell that has the same four nodes."""
    known: dict[frozenset[int], float] = {}
    for part in shell_parts(deck, model, corners=4):
        for nodes, stiffness in zip(part.nodes, penalty(part, model), strict=True):
            known[frozenset(nodes.tolist())] = float(stiffness)
    found = deck.find(SET_SEGMENT, sid=getattr(entry, field), referred_by=(entry, field))
    nodes, stiffness = model.corners(found, ("n1", "n2", "n3", "n4")), []
    for row, corners in enumerate(nodes.tolist()):
        if frozenset(corners) not in known:
            raise found.error("n1", f"no shell has the nodes of this segment; {QUADRILATERALS}", row)
        stiffness.append(known[frozenset(corners)])
    return Segments(nodes, np.array(stiffness))
