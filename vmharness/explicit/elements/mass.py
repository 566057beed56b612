"""*ELEMENT_MASS: a mass lumped on a node, without rotary inertia; it feels body loads."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.element_mass import ELEMENT_MASS
from vmharness.explicit.model import Model


def build(deck: Deck, model: Model) -> None:
    """Add the masses of the deck to their nodes."""
    for table in deck.all(ELEMENT_MASS):
        rows = [model.row(table, "nid", nid, row) for row, nid in enumerate(table.nid)]
        model.add_mass(np.array(rows, np.intp), table.mass)
