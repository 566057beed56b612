"""*ELEMENT_MASS as nodal masses."""

from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.support import supports

SUPPORTS = (supports(ELEMENT_MASS),)


def add(deck: Deck, model: Model) -> None:
    """Add the masses to their nodes."""
    for table in deck.all(ELEMENT_MASS):
        rows = model.nodes.find(table, "nid", table.nid)
        model.used[rows] = True
        for row, mass in zip(rows, table.mass, strict=True):
            model.mass[row] += mass
            model.lumped[row] += mass
