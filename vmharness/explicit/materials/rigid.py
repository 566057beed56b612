"""*MAT_RIGID: the part is one rigid body. E and PR serve contact alone; there is no law, for there is no stress.

CMO = 1 holds the body's centre and its rotations in global directions: CON1 and CON2 are codes like those of *NODE.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.rigid import MAT_RIGID

KEYWORD = MAT_RIGID

HISTORY: dict[str, int] = {}


def constants(deck: Deck, entry: Entry) -> tuple[float, float]:
    """Young's modulus E and Poisson's ratio, for contact; raises DeckError unless -1 < PR < 1/2."""
    if not -1.0 < entry.pr < 0.5:
        raise entry.error("pr", "must lie between -1 and 0.5")
    return entry.e, entry.pr
