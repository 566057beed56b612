"""*CONTROL_CONTACT: what of it acts on no contact of the deck is said."""

from vmharness.deck import Deck
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.explicit.contact.number import contacts_of
from vmharness.explicit.contact.without_effect import of_control
from vmharness.explicit.model.model import Model


def build(deck: Deck, model: Model) -> None:
    """Add the fact, where there is one."""
    control = deck.first(CONTROL_CONTACT)
    if control:
        model.facts |= of_control(control, contacts_of(deck))
