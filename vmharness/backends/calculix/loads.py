"""Nodal loads, pressures and base accelerations as *CLOAD with an amplitude."""

import numpy as np

from vmharness.backends._translation.loads import ALONG, FORCES, PRESSURES, loaded, unit_pressure
from vmharness.backends.calculix.clock import Clock, amplitude
from vmharness.backends.calculix.model import Lines, Model, real
from vmharness.deck import Deck
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.keywords.load.segment import LOAD_SEGMENT, LOAD_SEGMENT_SET
from vmharness.mesh.dof import place

SUPPORTS = FORCES + PRESSURES


def add(deck: Deck, model: Model) -> None:
    """Note the forces on nodes; the acceleration SF LC(t) of the base acts as -m SF LC(t)."""
    for entry in deck.all(LOAD_NODE_POINT, LOAD_NODE_SET):
        for row in loaded(deck, model.nodes, entry):
            model.load(row, place(entry), entry.lcid, entry.sf)
    for entry in deck.all(LOAD_SEGMENT, LOAD_SEGMENT_SET):
        force = unit_pressure(deck, model.nodes, entry)
        for row, axis in np.argwhere(force).tolist():
            model.load(row, axis, entry.lcid, entry.sf * float(force[row, axis]))
    for axis, keyword in enumerate(ALONG):
        for entry in deck.all(keyword):
            for row in np.flatnonzero(model.mass).tolist():
                model.load(row, axis, entry.lcid, -entry.sf * float(model.mass[row]))


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
