"""*MAT_RIGID (020): the part is one rigid body, so it has no stress and no kernel. E and PR serve contact alone.

CMO = 1 constrains the translation of the centre and the rotation of the body along global axes, as CON1 and CON2 say.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.explicit.materials.elastic import density, moduli

__all__ = ["CHANNELS", "HISTORY", "KEYWORD", "constants", "density", "moduli"]

KEYWORD = MAT_RIGID
HISTORY: dict[str, int] = {}
CHANNELS: dict[str, int] = {}


def constants(deck: Deck, entry: Entry) -> tuple[()]:
    """None, since there is no kernel."""
    return ()
