"""*CONTACT_ONE_WAY_SURFACE_TO_SURFACE: the nodes of surface A kept off the segments of surface B (type 10).

As *CONTACT_NODES_TO_SURFACE, with A given by its segments.
"""

from vmharness.deck import Deck
from vmharness.deck.keywords.contact import CONTACT_ONE_WAY_SURFACE_TO_SURFACE
from vmharness.explicit.contact.build import Kind, add_contacts
from vmharness.explicit.contact.supported import SEGMENTS, contact
from vmharness.explicit.model.model import Model

NAME = "one way surface to surface"
KIND = Kind(CONTACT_ONE_WAY_SURFACE_TO_SURFACE)
SUPPORTS = (contact(KIND, SEGMENTS, SEGMENTS),)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck."""
    add_contacts(deck, model, KIND)
