"""Planar rigid walls of the deck, each with the nodes that it acts on.

Nodes of rigid bodies are left out, as LS-DYNA leaves them out in its treatment by momentum: RWPNAL = 0 on
*CONTROL_CONTACT. Its treatment by penalty of these nodes (RWPNAL > 0) or of all nodes (RWPNAL < 0) is not supported.
"""

import math

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.deck.keywords.rigidwall import KEYWORDS
from vmharness.deck.rule import above, at_least, no_effect, only
from vmharness.deck.support import supports
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.body import find_bodies
from vmharness.explicit.state import Array, Flags, Index
from vmharness.explicit.walls.face import NORMAL, covers, face_of
from vmharness.explicit.walls.wall import PlanarWall
from vmharness.mesh.sets import node_set
from vmharness.mesh.supports import supported

SUPPORTS = tuple(
    supports(
        keyword,
        id=at_least(0),
        nsid=at_least(0),
        nsidex=at_least(0),
        boxid=only(0),
        offset=at_least(0.0),
        birth=at_least(0.0),
        death=above(0.0),
        rwksf=no_effect("acts on rigid bodies at rigid walls"),
        fric=at_least(0.0),
        wvel=only(0.0),
        **({"lenl": above(0.0), "lenm": above(0.0)} if "FINITE" in keyword.name else {}),
        **({"mass": above(0.0)} if "MOVING" in keyword.name else {}),
    )
    for keyword in KEYWORDS
)


def build(deck: Deck, model: Model) -> None:
    """Add a constraint for each wall, in the deck's order; a wall's number is its ID, or its place in that order."""
    entries = [entry for entry in deck.entries if entry.keyword in KEYWORDS]
    if not entries:
        return
    ruled, rigid, taken = _ruled(deck, model), _rigid_nodes(deck, model), set[int]()
    for place, entry in enumerate(entries, 1):
        number = entry.id or place
        if number in taken:
            raise entry.error("id", "another rigid wall has this number; give each its own by _ID")
        taken.add(number)
        model.constraints.append(_wall(deck, model, entry, number, ruled, rigid))


def _wall(deck: Deck, model: Model, entry: Entry, number: int, ruled: Flags, rigid: Flags) -> PlanarWall:
    if entry.death <= entry.birth:
        raise entry.error("death", f"the wall would end before its birth at {entry.birth:g}")
    moves = "v0" in entry.values
    if moves and entry.birth > 0.0:
        raise entry.error("birth", "not supported for a moving wall: whether it moves before is not certain")
    face = _face(entry)
    nodes = _nodes(deck, model, entry, face, ruled, rigid)
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


def _nodes(deck: Deck, model: Model, entry: Entry, face: Array, ruled: Flags, rigid: Flags) -> Index:
    """Rows of the nodes with mass of NSID (0: all) without NSIDEX, within OFFSET, that may move along the normal.

    `ruled` (n, 3): displacements ruled by another constraint; `rigid` (n,): nodes of rigid bodies.
    """
    nodes = node_set(deck, model, entry, "nsid") if entry.nsid else np.arange(model.node_count)
    nodes = nodes[(model.state.mass[nodes] > 0.0) | rigid[nodes]]
    if entry.nsidex:
        nodes = np.setdiff1d(nodes, node_set(deck, model, entry, "nsidex"))
    if entry.offset > 0.0:
        nodes = nodes[(model.x0[nodes] - face[0]) @ face[NORMAL] <= entry.offset]
    if rigid[nodes].any():
        _check_no_penalty(deck)
        model.facts["Rigid walls and rigid bodies"] = "the walls leave nodes of bodies alone: RWPNAL = 0"
        nodes = nodes[~rigid[nodes]]
    normal = np.abs(face[NORMAL]) > 1e-12
    held = ruled[nodes][:, normal]
    for row in nodes[held.any(axis=1) & ~held.all(axis=1)]:
        raise entry.error(
            "xh",
            f"node {model.ids[row]} has a support or prescribed motion oblique to the wall; not supported",
        )
    free = nodes[~held.any(axis=1)]
    if not free.size:
        raise entry.error("nsid", "no node that could meet the wall is free to move along its normal")
    return free


def _ruled(deck: Deck, model: Model) -> Flags:
    """Displacements (n, 3) that a support or a prescribed motion rules."""
    ruled = supported(deck, model)
    for constraint in model.constraints:
        if isinstance(constraint, PrescribedMotion):
            ruled[constraint.nodes, constraint.dof] = True
    return ruled[:, :3]


def _rigid_nodes(deck: Deck, model: Model) -> Flags:
    """Nodes (n,) of rigid bodies."""
    rigid = np.zeros(model.ids.size, bool)
    for body in find_bodies(deck, model):
        rigid[body.nodes] = True
    return rigid


def _check_no_penalty(deck: Deck) -> None:
    control = deck.first(CONTROL_CONTACT)
    if control and control.rwpnal > 0.0:
        what = "the penalty of rigid bodies at rigid walls is not supported; 0 leaves their nodes out"
        raise control.error("rwpnal", what)


def _check_in_front(model: Model, entry: Entry, wall: PlanarWall) -> None:
    """No node is behind a wall that acts from the start: it would pass through without a message."""
    if entry.birth > 0.0:
        return
    gaps = (model.x0[wall.nodes] - wall.face[0]) @ wall.normal
    for node, gap in zip(wall.nodes, gaps, strict=True):
        x, y, z = model.x0[node].tolist()
        if gap < -wall.reach and covers(wall.face, (x, y, z)):
            raise entry.error(
                "nsid", f"node {model.ids[node]} begins {-gap:.4g} behind the wall; move it, or leave it out"
            )
