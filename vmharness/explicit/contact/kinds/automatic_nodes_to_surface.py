"""*CONTACT_AUTOMATIC_NODES_TO_SURFACE: nodes kept off shells on either side, at the distance of thickness (type a5).

The gap counts from half the thickness of the segment's shell and half that of the node's; edges are rounded. A node
with a mass alone has no thickness. Contact with solids is on the outside, at their faces.
"""

from vmharness.deck import Deck
from vmharness.deck.keywords.contact import CONTACT_AUTOMATIC_NODES_TO_SURFACE
from vmharness.explicit.contact.build import Kind, add_contacts
from vmharness.explicit.contact.supported import NODES, SEGMENTS, contact
from vmharness.explicit.model.model import Model

NAME = "automatic nodes to surface"
KIND = Kind(CONTACT_AUTOMATIC_NODES_TO_SURFACE, automatic=True)
SUPPORTS = (contact(KIND, NODES, SEGMENTS),)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck."""
    add_contacts(deck, model, KIND)
