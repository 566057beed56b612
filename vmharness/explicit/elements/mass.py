"""*ELEMENT_MASS: a mass lumped on a node, without rotary inertia. Body loads act on it."""

from vmharness.deck import Deck
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.explicit.model.model import Model

NAME = "lumped mass"


def build(deck: Deck, model: Model) -> None:
    """Add the masses of the deck to their nodes."""
    for table in deck.all(ELEMENT_MASS):
        model.add_mass(model.find(table, "nid", table.nid), table.mass)
