"""*CONTACT_SURFACE_TO_SURFACE: two surfaces, the nodes of each kept off the segments of the other (type 3).

Two-way: see contact/contact.py for how the two passes share the force. One-sided, without thickness unless SHLTHK.
"""

from vmharness.deck import Deck
from vmharness.deck.keywords.contact import CONTACT_SURFACE_TO_SURFACE
from vmharness.explicit.contact.build import Kind, add_contacts
from vmharness.explicit.contact.supported import SEGMENTS, contact
from vmharness.explicit.model.model import Model

NAME = "surface to surface"
KIND = Kind(CONTACT_SURFACE_TO_SURFACE, two_way=True)
SUPPORTS = (contact(KIND, SEGMENTS, SEGMENTS),)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck."""
    add_contacts(deck, model, KIND)
