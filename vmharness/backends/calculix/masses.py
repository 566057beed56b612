"""*ELEMENT_MASS as MASS elements."""

from vmharness.backends.calculix.model import Model, real
from vmharness.deck import Deck
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.support import supports

SUPPORTS = (supports(ELEMENT_MASS),)


def add(deck: Deck, model: Model) -> None:
    """Add the masses to their nodes."""
    for entry in deck.all(ELEMENT_MASS):
        rows = model.nodes.find(entry, "nid", entry.nid)
        for eid, row, mass in zip(entry.eid.tolist(), rows.tolist(), entry.mass.tolist(), strict=True):
            model.add(entry.keyword, eid, "MASS", f"MASS{eid}", [row])
            model.elements += [f"*MASS,ELSET=MASS{eid}", real(mass)]
            model.mass[row] += mass
            model.lumped[row] += mass
