"""Prescribed motions as displacements over time: single-point constraints that follow a path."""

from vmharness.backends._translation.motions import SUPPORTS, displacement, motions, moved
from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.mesh.dof import place

__all__ = ["SUPPORTS", "add"]


def add(deck: Deck, model: Model) -> None:
    """Add a pattern with a constraint of unit size for each node that moves."""
    end = deck.one(CONTROL_TERMINATION).endtim
    for entry in motions(deck):
        series, pattern = model.next(), model.next()
        t, u = displacement(deck, entry, 1.01 * end)
        model.loads.append(["timeSeries", "Path", series, "-time", *t.tolist(), "-values", *u.tolist()])
        model.loads.append(["pattern", "Plain", pattern, series])
        model.loads += [
            ["sp", model.id(row), place(entry) + 1, 1.0] for row in moved(deck, model.nodes, entry)
        ]
