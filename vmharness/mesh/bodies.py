"""Rigid bodies of a deck, as figures show them: nodes, faces, lines, and the centre of mass."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.extra_nodes import (
    CONSTRAINED_EXTRA_NODES_NODE,
    CONSTRAINED_EXTRA_NODES_SET,
)
from vmharness.deck.keywords.constrained.nodal_rigid_body import (
    CONSTRAINED_NODAL_RIGID_BODY,
    CONSTRAINED_NODAL_RIGID_BODY_INERTIA,
)
from vmharness.deck.keywords.constrained.rigid_bodies import CONSTRAINED_RIGID_BODIES
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.keywords.initial.velocity_rigid_body import INITIAL_VELOCITY_RIGID_BODY
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART, has_inertia
from vmharness.mesh.elements import Elements
from vmharness.mesh.faces import faces_of_solids, outside
from vmharness.mesh.nodes import Array, Index, Nodes
from vmharness.mesh.sets import node_set, nodes_of_parts

FIXED = 7  # code of three axes that are held


@dataclass(frozen=True)
class Body:
    """A rigid body; rows are of the deck's nodes."""

    number: int
    name: str
    nodes: Index  # (m,)
    faces: Index  # (nf, 4) of its shells, and the outer ones of its solids
    lines: Index  # (ne, 2) its beams
    centre: Array | None  # (3,) its centre of mass, where the deck says it
    fixed: bool  # the centre is held in x, y and z
    motion: Array | None = (
        None  # (2, 3) initial velocity and angular velocity, where a card of the body gives them
    )


def rigid_parts(deck: Deck) -> set[int]:
    """Numbers of the parts of *MAT_RIGID."""
    rigid = {entry.mid for entry in deck.all(MAT_RIGID)}
    return {part.pid for part in deck.all(PART) if part.mid in rigid}


def bodies(deck: Deck, nodes: Nodes, shells: Elements, solids: Elements, beams: Elements) -> Iterator[Body]:
    """Every rigid part and nodal rigid body, in the order of the deck; merged parts are drawn as one body."""
    merged = {entry.pidc: entry.pidl for entry in deck.all(CONSTRAINED_RIGID_BODIES)}
    rigid = rigid_parts(deck)
    for part in deck.all(PART):
        if part.pid in rigid and part.pid not in merged:
            pids = {part.pid, *(joins for joins, lead in merged.items() if lead == part.pid)}
            own = [found.only(np.isin(found.pid, list(pids))) for found in (shells, solids, beams)]
            faces, _ = faces_of_solids(own[1].nodes)
            rows = np.concatenate([nodes_of_parts(deck, nodes, pids), *_extra(deck, nodes, pids)])
            yield Body(
                part.pid,
                part.heading,
                np.unique(rows),
                np.concatenate([own[0].nodes, faces[outside(faces)]]),
                own[2].nodes,
                _given(nodes, part) if has_inertia(part) else _centre(deck, nodes, own),
                _fixed(deck, part),
                _motion(deck, part, has_inertia(part)),
            )
    none = np.zeros((0, 4), np.intp), np.zeros((0, 2), np.intp)
    for entry in deck.all(CONSTRAINED_NODAL_RIGID_BODY, CONSTRAINED_NODAL_RIGID_BODY_INERTIA):
        given = entry.keyword is CONSTRAINED_NODAL_RIGID_BODY_INERTIA
        rows = node_set(deck, nodes, entry, "nsid" if entry.nsid else "pid")
        centre, motion = _given(nodes, entry) if given else None, _motion(deck, entry, given)
        yield Body(entry.pid, "", rows, *none, centre, False, motion)


def _extra(deck: Deck, nodes: Nodes, pids: set[int]) -> Iterator[Index]:
    for entry in deck.all(CONSTRAINED_EXTRA_NODES_NODE):
        if entry.pid in pids:
            yield np.array([nodes.row(entry, "nid", entry.nid)], np.intp)
    for entry in deck.all(CONSTRAINED_EXTRA_NODES_SET):
        if entry.pid in pids:
            yield node_set(deck, nodes, entry, "nsid")


def _fixed(deck: Deck, part: Entry) -> bool:
    material = deck.find(MAT_RIGID, mid=part.mid)
    return bool(material.cmo == 1 and material.con1 == FIXED)


def _motion(deck: Deck, definition: Entry, given: bool) -> Array | None:
    """Velocity and angular velocity by *INITIAL_VELOCITY_RIGID_BODY, else by the cards of inertia, if there are any."""
    names = ("vtx", "vty", "vtz", "vrx", "vry", "vrz")
    for entry in deck.all(INITIAL_VELOCITY_RIGID_BODY):
        if entry.pid == definition.pid:
            definition, given, names = entry, True, ("vx", "vy", "vz", "vxr", "vyr", "vzr")
    return np.array([definition.values[name] for name in names]).reshape(2, 3) if given else None


def _given(nodes: Nodes, entry: Entry) -> Array:
    """The centre of mass that a card of inertia gives, by coordinates or as a node."""
    if entry.nodeid:
        return nodes.x0[nodes.row(entry, "nodeid", entry.nodeid)]
    return np.array([entry.xc, entry.yc, entry.zc])


def _centre(deck: Deck, nodes: Nodes, own: list[Elements]) -> Array | None:
    """The centre of beams alone, or of solids alone; None for shells, which may differ in thickness, and for mixtures.

    Beams count by their lengths, solids by their volumes. Lumped masses move the centre: then it is None as well.
    """
    shells, solids, beams = (found.nodes for found in own)
    lumped = [nodes.find(table, "nid", table.nid) for table in deck.all(ELEMENT_MASS)]
    every = np.concatenate([shells.ravel(), solids.ravel(), beams.ravel()])
    if (
        shells.size
        or bool(solids.size) == bool(beams.size)
        or np.isin(every, np.concatenate([*lumped, []])).any()
    ):
        return None
    if beams.size:
        weight = np.linalg.norm(np.diff(nodes.x0[beams], axis=1)[:, 0], axis=1)
        middle = nodes.x0[beams].mean(axis=1)
    else:
        weight, middle = _tetrahedra(nodes.x0, faces_of_solids(solids)[0])
    return np.asarray(weight @ middle / weight.sum()) if weight.sum() else None


def _tetrahedra(x: Array, faces: Index) -> tuple[Array, Array]:
    """Volumes (n,) and centres (n, 3) of the tetrahedra from the origin to each triangle of the faces.

    V = a . (b x c)/6 is negative where the origin is outside; of faces inside the body the two contributions cancel.
    """
    corners = np.concatenate([x[faces[:, [0, 1, 2]]], x[faces[:, [0, 2, 3]]]])
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0
    return volume, corners.sum(axis=1) / 4.0
