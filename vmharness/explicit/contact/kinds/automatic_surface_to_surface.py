"""*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE: two surfaces with thickness, the nodes of each kept off the other (type a3).

Two-way: see contact/contact.py for how the two passes share the force, and automatic_nodes_to_surface.py for the gap.
"""

from vmharness.deck import Deck
from vmharness.deck.keywords.contact import CONTACT_AUTOMATIC_SURFACE_TO_SURFACE
from vmharness.explicit.contact.build import Kind, add_contacts
from vmharness.explicit.contact.supported import SEGMENTS, contact
from vmharness.explicit.model.model import Model

NAME = "automatic surface to surface"
KIND = Kind(CONTACT_AUTOMATIC_SURFACE_TO_SURFACE, automatic=True, two_way=True)
SUPPORTS = (contact(KIND, SEGMENTS, SEGMENTS),)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck."""
    add_contacts(deck, model, KIND)
