"""Prescribed motions as displacements over time: *BOUNDARY with an amplitude."""

import numpy as np

from vmharness.backends.calculix.model import Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.boundary.prescribed_motion import (
    BOUNDARY_PRESCRIBED_MOTION_NODE,
    BOUNDARY_PRESCRIBED_MOTION_SET,
)
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.rule import among, at_least, only
from vmharness.deck.support import supports
from vmharness.mesh.dof import place
from vmharness.mesh.sets import node_set

KEYWORDS = (BOUNDARY_PRESCRIBED_MOTION_NODE, BOUNDARY_PRESCRIBED_MOTION_SET)
VELOCITY, DISPLACEMENT = 0, 2  # VAD
SMALL = 0.05  # of the size of the model, which a driven node may move
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


def add(deck: Deck, model: Model) -> None:
    """Add an amplitude for each card, and a constraint for each of its nodes."""
    end = deck.one(CONTROL_TERMINATION).endtim
    for number, entry in enumerate([entry for entry in deck.entries if entry.keyword in KEYWORDS]):
        t, u = displacement(deck, entry, 1.01 * end)
        _refuse_large_strain(model, entry, float(np.abs(u[t <= 1.01 * end]).max()))
        model.motions[f"MOTION{number}"] = t, u
        dof = place(entry) + 1
        model.driven.append(f"*BOUNDARY,AMPLITUDE=MOTION{number}")
        model.driven += [f"{row + 1},{dof},{dof},1." for row in moved(model, entry)]


def _refuse_large_strain(model: Model, entry: Entry, u: float) -> None:
    """Raise DeckError where solids are driven by more than a small part of the size of the model."""
    size = float(np.ptp(model.nodes.x0[model.used], axis=0).max())
    if u > SMALL * size and any(name == ELEMENT_SOLID.name for name, _ in model.members):
        what = (
            f"calculix: the motion is {u / size:.3g} of the size of the model; at large strain its elastic law, "
            "St Venant-Kirchhoff, is another one than that of *MAT_ELASTIC, a rate by Jaumann"
        )
        raise entry.error(None, what)


def moved(model: Model, entry: Entry) -> list[int]:
    """The rows of the nodes that a card moves."""
    if entry.keyword is BOUNDARY_PRESCRIBED_MOTION_NODE:
        return [model.nodes.row(entry, "nid", entry.nid)]
    return [int(row) for row in node_set(model.deck, model.nodes, entry, "nsid")]


def displacement(deck: Deck, entry: Entry, end: float) -> tuple[np.ndarray, np.ndarray]:
    """Times and displacements: the curve itself, or the integral of a velocity that is linear between its points."""
    t, value = points(deck.find(DEFINE_CURVE, lcid=entry.lcid, referred_by=(entry, "lcid")))
    if entry.vad == DISPLACEMENT:
        return t, entry.sf * value
    inside = t[(t > 0.0) & (t < end)]
    constant = not inside.size and np.interp(0.0, t, value) == np.interp(end, t, value)
    fine = np.array([0.0, end]) if constant else np.union1d(np.linspace(0.0, end, SAMPLES), inside)
    v = np.interp(fine, t, entry.sf * value)
    return fine, np.concatenate([[0.0], np.cumsum(0.5 * (v[1:] + v[:-1]) * np.diff(fine))])
