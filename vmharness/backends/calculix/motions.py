"""Prescribed motions as displacements over time: *BOUNDARY with an amplitude."""

import numpy as np

from vmharness.backends._translation.motions import SUPPORTS, displacement, motions, moved
from vmharness.backends.calculix.model import Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.mesh.dof import place

SMALL = 0.05  # of the size of the model, which a driven node may move

__all__ = ["SUPPORTS", "add"]


def add(deck: Deck, model: Model) -> None:
    """Add an amplitude for each card, and a constraint for each of its nodes."""
    end = deck.one(CONTROL_TERMINATION).endtim
    for number, entry in enumerate(motions(deck)):
        t, u = displacement(deck, entry, 1.01 * end)
        _refuse_large_strain(model, entry, float(np.abs(u[t <= 1.01 * end]).max()))
        model.motions[f"MOTION{number}"] = t, u
        dof = place(entry) + 1
        model.driven.append(f"*BOUNDARY,AMPLITUDE=MOTION{number}")
        model.driven += [f"{row + 1},{dof},{dof},1." for row in moved(deck, model.nodes, entry)]


def _refuse_large_strain(model: Model, entry: Entry, u: float) -> None:
    """Raise DeckError where solids are driven by more than a small part of the size of the model."""
    size = float(np.ptp(model.nodes.x0[model.used], axis=0).max())
    if u > SMALL * size and any(name == ELEMENT_SOLID.name for name, _ in model.members):
        what = (
            f"calculix: the motion is {u / size:.3g} of the size of the model; at large strain its elastic law, "
            "St Venant-Kirchhoff, is another one than that of *MAT_ELASTIC, a rate by Jaumann"
        )
        raise entry.error(None, what)
