"""*CONTACT_AUTOMATIC_SINGLE_SURFACE: a surface kept off itself, all of its parts off each other (type 13).

Only SURFA is given, with SFSA, SAST and SFSAT; 0 stands for all parts. A node has no contact with the segments of which
it is a corner. The gap is that of automatic_nodes_to_surface.py, with thickness at most 0.4 times the shortest side of
a shell (SSTHK = 0).
"""

from vmharness.deck import Deck
from vmharness.deck.keywords.contact import CONTACT_AUTOMATIC_SINGLE_SURFACE
from vmharness.explicit.contact.build import Kind, add_contacts
from vmharness.explicit.contact.supported import NONE, SEGMENTS, contact
from vmharness.explicit.model.model import Model

NAME = "automatic single surface"
KIND = Kind(CONTACT_AUTOMATIC_SINGLE_SURFACE, automatic=True, single_surface=True)
SUPPORTS = (contact(KIND, SEGMENTS, NONE),)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck; raises DeckError for anything on side B."""
    for entry in deck.all(KIND.keyword):
        for field, default in (("surfb", 0), ("sfsb", 1.0), ("sbst", 0.0), ("sfsbt", 1.0)):
            if getattr(entry, field) != default:
                raise entry.error(field, "a single surface has no second side")
    add_contacts(deck, model, KIND)
