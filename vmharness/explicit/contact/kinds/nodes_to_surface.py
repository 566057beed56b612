"""*CONTACT_NODES_TO_SURFACE: nodes kept on the outer side of segments by a penalty (type 5, one-way).

One-sided, and without the thickness of shells unless SHLTHK asks for it. Segments resist with

    k = SLSFAC SFSB K A / d (shells)      k = SLSFAC SFSB K A^2 / V (solids)

or with the stiffness of the tracked node's own elements, with SFSA, if that is less (PENOPT = 1); a node with a mass
alone sets none. (LS-DYNA theory manual, penalty method; VM-LSDYNA-SOLVE-061.) PENCHK = 0 releases no node, however
deep.
"""

from vmharness.deck import Deck
from vmharness.deck.keywords.contact import CONTACT_NODES_TO_SURFACE
from vmharness.explicit.contact.build import Kind, add_contacts
from vmharness.explicit.contact.supported import NODES, SEGMENTS, contact
from vmharness.explicit.model.model import Model

NAME = "nodes to surface"
KIND = Kind(CONTACT_NODES_TO_SURFACE)
SUPPORTS = (contact(KIND, NODES, SEGMENTS),)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck."""
    add_contacts(deck, model, KIND)
