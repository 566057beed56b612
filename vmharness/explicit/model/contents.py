"""What a deck has: kinds of elements, for options that act on these alone."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID


def shells(deck: Deck) -> bool:
    """Whether the deck has shells."""
    return bool(deck.all(ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS))


def solids(deck: Deck) -> bool:
    """Whether the deck has solids."""
    return bool(deck.all(ELEMENT_SOLID))


def beams(deck: Deck) -> bool:
    """Whether the deck has beams or trusses."""
    return bool(deck.all(ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION))


def wedges(deck: Deck) -> bool:
    """Whether the deck has a solid that repeats a node."""
    return any(np.any((table.n5 == table.n6) | (table.n3 == table.n4)) for table in deck.all(ELEMENT_SOLID))
