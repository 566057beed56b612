"""*ELEMENT_MASS: a mass lumped on a node, without rotary inertia. Body loads act on it."""

from vmharness.deck import Deck
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.rule import at_least, no_effect
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model

SUPPORTS = (supports(ELEMENT_MASS, mass=at_least(0.0), pid=no_effect("affects output only")),)

NAME = "lumped mass"


def build(deck: Deck, model: Model) -> None:
    """Add the masses of the deck to their nodes."""
    for table in deck.all(ELEMENT_MASS):
        model.add_mass(model.find(table, "nid", table.nid), table.mass)
