"""Nodal loads and base accelerations as load patterns with a path over time."""

import numpy as np

from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.load.body import LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.keywords.load.segment import CORNERS, LOAD_SEGMENT, LOAD_SEGMENT_SET
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.rule import among, no_effect, only
from vmharness.deck.support import supports
from vmharness.mesh.dof import place
from vmharness.mesh.faces import area_vectors
from vmharness.mesh.sets import node_set

LOAD = {"dof": among(1, 2, 3), "cid": only(0), **{f"m{i}": only(0) for i in (1, 2, 3)}}
ALONG = (LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z)
SUPPORTS = (
    *(supports(keyword, **LOAD) for keyword in (LOAD_NODE_POINT, LOAD_NODE_SET)),
    supports(LOAD_SEGMENT, at=only(0.0), n5=only(0)),
    supports(LOAD_SEGMENT_SET, at=only(0.0)),
    *(supports(keyword, cid=only(0), lciddr=no_effect("of dynamic relaxation")) for keyword in ALONG),
)


def add(deck: Deck, model: Model) -> None:
    """Add a pattern for each load: forces, or the acceleration SF LC(t) of the base, which acts as -m SF LC(t)."""
    for entry in deck.all(LOAD_NODE_POINT, LOAD_NODE_SET):
        point = entry.keyword is LOAD_NODE_POINT
        rows = (
            [model.nodes.row(entry, "nid", entry.nid)]
            if point
            else node_set(deck, model.nodes, entry, "nsid").tolist()
        )
        _pattern(deck, model, entry, "Plain")
        vector = np.eye(3)[place(entry)].tolist()
        model.loads += [["load", model.id(row), *vector] for row in rows if model.used[row]]
    _pressures(deck, model)
    for axis, keyword in enumerate(ALONG):
        for entry in deck.all(keyword):
            _pattern(deck, model, entry, "UniformExcitation", axis + 1)


def _pressures(deck: Deck, model: Model) -> None:
    """Pressures as forces on the corners of the segments, in the direction of the normals at the beginning."""
    for entry in deck.all(LOAD_SEGMENT, LOAD_SEGMENT_SET):
        found = entry
        if entry.keyword is LOAD_SEGMENT_SET:
            found = deck.find(SET_SEGMENT, sid=entry.ssid, referred_by=(entry, "ssid"))
        faces = np.atleast_2d(np.column_stack([_rows(model, found, name) for name in CORNERS]))
        force = np.zeros((model.nodes.ids.size, 3))
        for corners, area in zip(faces, area_vectors(model.nodes.x0[faces]), strict=True):
            distinct = np.unique(corners)
            force[distinct] -= area / distinct.size
        _pattern(deck, model, entry, "Plain")
        model.loads += [["load", model.id(row), *force[row].tolist()] for row in np.unique(faces)]


def _rows(model: Model, entry: Entry, name: str) -> np.ndarray:
    return model.nodes.find(entry, name, np.atleast_1d(getattr(entry, name)))


def _pattern(deck: Deck, model: Model, entry: Entry, kind: str, dof: int = 0) -> None:
    """A time series SF LC(t), and a pattern that follows it."""
    t, value = points(deck.find(DEFINE_CURVE, lcid=entry.lcid, referred_by=(entry, "lcid")))
    series, pattern = model.next(), model.next()
    model.loads.append(
        ["timeSeries", "Path", series, "-time", *t.tolist(), "-values", *(entry.sf * value).tolist()]
    )
    model.loads.append(
        ["pattern", kind, pattern, dof, "-accel", series] if dof else ["pattern", kind, pattern, series]
    )
