"""Prescribed motions of nodes, as displacements over time."""

import numpy as np

from vmharness.backends._translation.loads import curve
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.boundary.prescribed_motion import (
    BOUNDARY_PRESCRIBED_MOTION_NODE,
    BOUNDARY_PRESCRIBED_MOTION_SET,
)
from vmharness.deck.rule import among, at_least, only
from vmharness.deck.support import supports
from vmharness.mesh.nodes import Array, Nodes
from vmharness.mesh.sets import node_set

KEYWORDS = (BOUNDARY_PRESCRIBED_MOTION_NODE, BOUNDARY_PRESCRIBED_MOTION_SET)
VELOCITY, DISPLACEMENT = 0, 2  # VAD
SAMPLES = 20_000  # of a displacement that is the integral of a velocity that changes

SUPPORTS = tuple(
    supports(
        keyword,
        dof=among(1, 2, 3),
        vad=among(VELOCITY, DISPLACEMENT),
        vid=only(0),
        birth=only(0.0),
        death=at_least(1e20),
    )
    for keyword in KEYWORDS
)


def motions(deck: Deck) -> list[Entry]:
    """The cards in the order of the deck."""
    return [entry for entry in deck.entries if entry.keyword in KEYWORDS]


def moved(deck: Deck, nodes: Nodes, entry: Entry) -> list[int]:
    """The rows of the nodes that a card moves."""
    if entry.keyword is BOUNDARY_PRESCRIBED_MOTION_NODE:
        return [nodes.row(entry, "nid", entry.nid)]
    return [int(row) for row in node_set(deck, nodes, entry, "nsid")]


def displacement(deck: Deck, entry: Entry, end: float) -> tuple[Array, Array]:
    """Times and displacements: the curve itself, or the integral of a velocity that is linear between its points."""
    t, value = curve(deck, entry)
    if entry.vad == DISPLACEMENT:
        return t, entry.sf * value
    inside = t[(t > 0.0) & (t < end)]
    constant = not inside.size and np.interp(0.0, t, value) == np.interp(end, t, value)
    fine = np.array([0.0, end]) if constant else np.union1d(np.linspace(0.0, end, SAMPLES), inside)
    v = np.interp(fine, t, entry.sf * value)
    return fine, np.concatenate([[0.0], np.cumsum(0.5 * (v[1:] + v[:-1]) * np.diff(fine))])
