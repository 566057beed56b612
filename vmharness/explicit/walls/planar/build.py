"""Planar rigid walls from the deck."""

import math

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.rigidwall import KEYWORDS
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.explicit.walls.planar.face import covers, face_of
from vmharness.explicit.walls.planar.tracked import rigid_nodes, tracked
from vmharness.explicit.walls.planar.wall import PlanarWall
from vmharness.mesh.supports import supported

Flags = NDArray[np.bool_]


def build(deck: Deck, model: Model) -> None:
    """Add a constraint for each wall, in the deck's order; a wall's number is its ID, or its place."""
    entries = [entry for entry in deck.entries if entry.keyword in KEYWORDS]
    if not entries:
        return
    ruled, rigid, taken = _ruled(deck, model), rigid_nodes(deck, model), set[int]()
    for place, entry in enumerate(entries, 1):
        number = entry.id or place
        if number in taken:
            raise entry.error("id", "another rigid wall has this number; give each its own by _ID")
        taken.add(number)
        model.constraints.append(_wall(deck, model, entry, number, ruled, rigid))


def _ruled(deck: Deck, model: Model) -> Flags:
    """Which displacements (n, 3) a support or a prescribed motion rules."""
    ruled = supported(deck, model)
    for constraint in model.constraints:
        if isinstance(constraint, PrescribedMotion):
            ruled[constraint.nodes, constraint.dof] = True
    return ruled[:, :3]


def _wall(deck: Deck, model: Model, entry: Entry, number: int, ruled: Flags, rigid: Flags) -> PlanarWall:
    if entry.death <= entry.birth:
        raise entry.error("death", f"the wall would end before its birth at {entry.birth:g}")
    moves = "v0" in entry.values
    if moves and entry.birth > 0.0:
        raise entry.error("birth", "not supported for a moving wall: whether it moves before is not certain")
    face = _face(entry)
    nodes = tracked(deck, model, entry, face, ruled, rigid)
    wall = PlanarWall(
        number, nodes, face, _friction(entry), entry.birth, entry.death, entry.mass if moves else math.inf,
        entry.v0 if moves else 0.0,
    )  # fmt: skip
    wall.begin(model.x0)
    _check_in_front(model, entry, wall)
    model.facts[f"Rigid wall {number}"] = f"{nodes.size} nodes"
    return wall


def _face(entry: Entry) -> Array:
    tail, head = (np.array([getattr(entry, f"{axis}{end}") for axis in "xyz"]) for end in "th")
    try:
        if "lenl" not in entry.values:
            return face_of(tail, head)
        edge = np.array([entry.xhev, entry.yhev, entry.zhev])
        return face_of(tail, head, edge, (entry.lenl, entry.lenm))
    except ValueError as error:
        raise entry.error("xhev" if "edge" in str(error) else "xh", str(error)) from None


def _friction(entry: Entry) -> float:
    """f: FRIC, and infinity for FRIC = 1."""
    if entry.fric > 1.0:
        raise entry.error("fric", "only 0, 1 and what lies between are supported")
    return math.inf if entry.fric == 1.0 else float(entry.fric)


def _check_in_front(model: Model, entry: Entry, wall: PlanarWall) -> None:
    """A node behind a wall that acts from the start would pass unseen."""
    if entry.birth > 0.0:
        return
    gaps = (model.x0[wall.nodes] - wall.face[0]) @ wall.normal
    for node, gap in zip(wall.nodes, gaps, strict=True):
        x, y, z = model.x0[node].tolist()
        if gap < -wall.reach and covers(wall.face, (x, y, z)):
            raise entry.error(
                "nsid", f"node {model.ids[node]} begins {-gap:.4g} behind the wall; move it, or leave it out"
            )
