"""Places and directions of the loads and prescribed motions of a deck."""

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.boundary.prescribed_motion import (
    BOUNDARY_PRESCRIBED_MOTION_NODE,
    BOUNDARY_PRESCRIBED_MOTION_SET,
)
from vmharness.deck.keywords.boundary.prescribed_motion_rigid import BOUNDARY_PRESCRIBED_MOTION_RIGID
from vmharness.deck.keywords.constrained.nodal_rigid_body import (
    CONSTRAINED_NODAL_RIGID_BODY,
    CONSTRAINED_NODAL_RIGID_BODY_INERTIA,
)
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.load.body import LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.keywords.load.rigid_body import LOAD_RIGID_BODY
from vmharness.deck.keywords.load.segment import CORNERS, LOAD_SEGMENT, LOAD_SEGMENT_SET
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.mesh.dof import place
from vmharness.mesh.faces import area_vectors
from vmharness.mesh.nodes import Array, Index, Nodes
from vmharness.mesh.sets import node_set, nodes_of_parts

Arrows = tuple[Array, Array]  # places (n, 3), directions (n, 3)


def arrows(deck: Deck, nodes: Nodes) -> dict[str, Arrows]:
    """Places of forces, pressures and prescribed motions, and their directions at the largest value of the curve."""
    forces = deck.all(LOAD_RIGID_BODY, LOAD_NODE_POINT, LOAD_NODE_SET)
    motions = [
        entry
        for entry in deck.entries
        if entry.keyword in (BOUNDARY_PRESCRIBED_MOTION_NODE, BOUNDARY_PRESCRIBED_MOTION_SET)
    ]
    found = {
        "force": [_along_axis(deck, nodes, entry) for entry in forces if entry.dof < 4],
        "pressure": list(_pressures(deck, nodes)),
        "motion": [
            _along_axis(deck, nodes, entry)
            for entry in (*motions, *deck.all(BOUNDARY_PRESCRIBED_MOTION_RIGID))
            if entry.dof < 4
        ],
    }
    return {what: _together(one) for what, one in found.items() if one}


def gravity(deck: Deck) -> Array:
    """The acceleration (3,) that body loads give at t = 0."""
    b = np.zeros(3)
    for axis, keyword in enumerate((LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z)):
        for entry in deck.all(keyword):
            b[axis] += -entry.sf * float(np.interp(0.0, *_curve(deck, entry)))
    return b


def _along_axis(deck: Deck, nodes: Nodes, entry: Entry) -> Arrows:
    """A force or motion along x, y or z, at each of its nodes."""
    at = _places(deck, nodes, entry)
    along = np.sign(entry.sf * _largest(deck, entry)) * np.eye(3)[place(entry)]
    return at, np.tile(along, (len(at), 1))


def _places(deck: Deck, nodes: Nodes, entry: Entry) -> Array:
    """The nodes of a load or of a motion (m, 3); for a rigid body the middle of its nodes."""
    if "nid" in entry.values:
        return nodes.x0[[nodes.row(entry, "nid", entry.nid)]]
    if "nsid" in entry.values:
        return nodes.x0[node_set(deck, nodes, entry, "nsid")]
    return nodes.x0[_body(deck, nodes, entry)].mean(axis=0, keepdims=True)


def _body(deck: Deck, nodes: Nodes, entry: Entry) -> Index:
    """Rows of the nodes of the rigid body that PID names."""
    for body in deck.all(CONSTRAINED_NODAL_RIGID_BODY, CONSTRAINED_NODAL_RIGID_BODY_INERTIA):
        if body.pid == entry.pid:
            return node_set(deck, nodes, body, "nsid" if body.nsid else "pid")
    return nodes_of_parts(deck, nodes, {entry.pid})


def _pressures(deck: Deck, nodes: Nodes) -> Iterator[Arrows]:
    """Arrows at the middle of the segments, against their normals where the pressure is positive."""
    for entry in deck.all(LOAD_SEGMENT, LOAD_SEGMENT_SET):
        if entry.keyword is LOAD_SEGMENT:
            faces = np.array([[nodes.row(entry, name, getattr(entry, name)) for name in CORNERS]], np.intp)
        else:
            found = deck.find(SET_SEGMENT, sid=entry.ssid, referred_by=(entry, "ssid"))
            faces = nodes.corners(found, CORNERS)
        corners = nodes.x0[faces]
        normal = 2.0 * area_vectors(corners)
        value = -np.sign(entry.sf * _largest(deck, entry)) / np.linalg.norm(normal, axis=1)
        yield corners.mean(axis=1), value[:, None] * normal


def _together(found: Iterable[Arrows]) -> Arrows:
    at, along = zip(*found, strict=True)
    return np.concatenate(at), np.concatenate(along)


def _curve(deck: Deck, entry: Entry) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return points(deck.find(DEFINE_CURVE, lcid=entry.lcid, referred_by=(entry, "lcid")))


def _largest(deck: Deck, entry: Entry) -> float:
    """The ordinate of the entry's curve that is farthest from zero, the first of such."""
    _, ordinate = _curve(deck, entry)
    return float(ordinate[np.argmax(np.abs(ordinate))])
