"""Nodal loads, pressures and base accelerations as *CLOAD with an amplitude."""

import numpy as np

from vmharness.backends.calculix.clock import Clock, amplitude
from vmharness.backends.calculix.model import Lines, Model, real
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
    """Note the forces on nodes; the acceleration SF LC(t) of the base acts as -m SF LC(t)."""
    for entry in deck.all(LOAD_NODE_POINT, LOAD_NODE_SET):
        if entry.keyword is LOAD_NODE_POINT:
            rows = [model.nodes.row(entry, "nid", entry.nid)]
        else:
            rows = node_set(deck, model.nodes, entry, "nsid").tolist()
        for row in rows:
            model.load(row, place(entry), entry.lcid, entry.sf)
    for entry in deck.all(LOAD_SEGMENT, LOAD_SEGMENT_SET):
        force = _pressure(deck, model, entry)
        for row, axis in np.argwhere(force).tolist():
            model.load(row, axis, entry.lcid, entry.sf * float(force[row, axis]))
    for axis, keyword in enumerate(ALONG):
        for entry in deck.all(keyword):
            for row in np.flatnonzero(model.mass).tolist():
                model.load(row, axis, entry.lcid, -entry.sf * float(model.mass[row]))


def _pressure(deck: Deck, model: Model, entry: Entry) -> np.ndarray:
    """Forces (n, 3) of the pressure 1 on the corners of the segments, along their normals at the beginning."""
    found = entry
    if entry.keyword is LOAD_SEGMENT_SET:
        found = deck.find(SET_SEGMENT, sid=entry.ssid, referred_by=(entry, "ssid"))
    columns = [model.nodes.find(found, name, np.atleast_1d(getattr(found, name))) for name in CORNERS]
    faces = np.column_stack(columns)
    force = np.zeros((model.nodes.ids.size, 3))
    for corners, area in zip(faces, area_vectors(model.nodes.x0[faces]), strict=True):
        distinct = np.unique(corners)
        force[distinct] -= area / distinct.size
    return force


def amplitudes(model: Model, clock: Clock) -> Lines:
    """An amplitude for each combination of curves that acts on a node: CalculiX adds no two loads on one node."""
    lines: Lines = []
    for name, curves in _combinations(model).items():
        found = [points(model.deck.find(DEFINE_CURVE, lcid=lcid)) for lcid, _ in curves]
        t = np.unique(np.concatenate([each for each, _ in found]))
        total = np.sum(
            [factor * np.interp(t, *curve) for (_, factor), curve in zip(curves, found, strict=True)], axis=0
        )
        lines += amplitude(name, t, total, clock)
    return lines


def forces(model: Model) -> Lines:
    """*CLOAD of the step."""
    names = {curves: name for name, curves in _combinations(model).items()}
    lines: Lines = []
    for (row, axis), curves in model.loads.items():
        if model.used[row] and any(curves.values()):
            shares, factor = _shares(curves)
            lines += [f"*CLOAD,AMPLITUDE={names[shares]}", f"{row + 1},{axis + 1},{real(factor)}"]
    return lines


Shares = tuple[tuple[int, float], ...]  # LCID, and its factor relative to that of the first


def _shares(curves: dict[int, float]) -> tuple[Shares, float]:
    """Curves with their factors relative to the first that acts, and the factor of that."""
    acting = {lcid: factor for lcid, factor in curves.items() if factor}
    first = next(iter(acting.values()))
    return tuple((lcid, factor / first) for lcid, factor in acting.items()), first


def _combinations(model: Model) -> dict[str, Shares]:
    distinct = dict.fromkeys(_shares(curves)[0] for curves in model.loads.values() if any(curves.values()))
    return {f"LOAD{number}": shares for number, shares in enumerate(distinct)}
