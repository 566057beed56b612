"""Nodal loads, pressures and base accelerations, with their curves."""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.load.body import LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.keywords.load.segment import CORNERS, LOAD_SEGMENT, LOAD_SEGMENT_SET
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.rule import among, no_effect, only
from vmharness.deck.support import supports
from vmharness.mesh.faces import area_vectors
from vmharness.mesh.nodes import Array, Nodes
from vmharness.mesh.sets import node_set

LOAD = {"dof": among(1, 2, 3), "cid": only(0), **{f"m{i}": only(0) for i in (1, 2, 3)}}
ALONG = (LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z)

FORCES = (
    *(supports(keyword, **LOAD) for keyword in (LOAD_NODE_POINT, LOAD_NODE_SET)),
    *(supports(keyword, cid=only(0), lciddr=no_effect("of dynamic relaxation")) for keyword in ALONG),
)
PRESSURES = (
    supports(LOAD_SEGMENT, at=only(0.0), n5=only(0)),
    supports(LOAD_SEGMENT_SET, at=only(0.0)),
    supports(SET_SEGMENT),
)


def curve(deck: Deck, entry: Entry) -> tuple[Array, Array]:
    """Abscissae and ordinates of the curve LCID of a card, without its SF."""
    return points(deck.find(DEFINE_CURVE, lcid=entry.lcid, referred_by=(entry, "lcid")))


def loaded(deck: Deck, nodes: Nodes, entry: Entry) -> list[int]:
    """The rows of the nodes of a nodal load."""
    if entry.keyword is LOAD_NODE_POINT:
        return [nodes.row(entry, "nid", entry.nid)]
    return [int(row) for row in node_set(deck, nodes, entry, "nsid")]


def unit_pressure(deck: Deck, nodes: Nodes, entry: Entry) -> Array:
    """Forces (n, 3) of the pressure 1 on the corners of the segments, against their normals at the beginning."""
    found = entry
    if entry.keyword is LOAD_SEGMENT_SET:
        found = deck.find(SET_SEGMENT, sid=entry.ssid, referred_by=(entry, "ssid"))
    columns = [nodes.find(found, name, np.atleast_1d(getattr(found, name))) for name in CORNERS]
    faces = np.column_stack(columns)
    force = np.zeros((nodes.ids.size, 3))
    for corners, area in zip(faces, area_vectors(nodes.x0[faces]), strict=True):
        distinct = np.unique(corners)
        force[distinct] -= area / distinct.size
    return force
