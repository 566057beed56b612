"""Nodal loads and base accelerations as load patterns with a path over time."""

import numpy as np

from vmharness.backends._translation.loads import ALONG, FORCES, PRESSURES, curve, loaded, unit_pressure
from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.keywords.load.segment import LOAD_SEGMENT, LOAD_SEGMENT_SET
from vmharness.mesh.dof import place

SUPPORTS = FORCES + PRESSURES


def add(deck: Deck, model: Model) -> None:
    """Add a pattern for each load: forces, or the acceleration SF LC(t) of the base, which acts as -m SF LC(t)."""
    for entry in deck.all(LOAD_NODE_POINT, LOAD_NODE_SET):
        _pattern(deck, model, entry, "Plain")
        vector = np.eye(3)[place(entry)].tolist()
        model.loads += [
            ["load", model.id(row), *vector] for row in loaded(deck, model.nodes, entry) if model.used[row]
        ]
    for entry in deck.all(LOAD_SEGMENT, LOAD_SEGMENT_SET):
        force = unit_pressure(deck, model.nodes, entry)
        _pattern(deck, model, entry, "Plain")
        rows = np.flatnonzero(force.any(axis=1)).tolist()
        model.loads += [["load", model.id(row), *force[row].tolist()] for row in rows]
    for axis, keyword in enumerate(ALONG):
        for entry in deck.all(keyword):
            _pattern(deck, model, entry, "UniformExcitation", axis + 1)


def _pattern(deck: Deck, model: Model, entry: Entry, kind: str, dof: int = 0) -> None:
    """A time series SF LC(t), and a pattern that follows it."""
    t, value = curve(deck, entry)
    series, pattern = model.next(), model.next()
    model.loads.append(
        ["timeSeries", "Path", series, "-time", *t.tolist(), "-values", *(entry.sf * value).tolist()]
    )
    model.loads.append(
        ["pattern", kind, pattern, dof, "-accel", series] if dof else ["pattern", kind, pattern, series]
    )
