"""Materials of parts: the card, and the module of the folder of materials that holds its law.

A module of the folder has

    KEYWORD     the *MAT_... card
    HISTORY     history variables per point, by state of stress; what is not listed the law cannot do
    constants   (deck, entry) -> tuple of what the law needs of the card, made once
    CHANNELS    names of history variables that can be read off, by place; may be missing

and a kernel for each state of stress of HISTORY: plane_stress (shells), solid, uniaxial (bars), spring.
"""

from functools import cache
from types import ModuleType

from vmharness import plugins
from vmharness.deck import Deck, Entry, Keyword

FOLDER = "vmharness.explicit.materials"


@cache
def laws() -> dict[Keyword, ModuleType]:
    """The modules of the folder by their cards: listed once, however many parts ask."""
    return {module.KEYWORD: module for module in plugins.modules(FOLDER, "KEYWORD", "HISTORY", "constants")}


def material_of(deck: Deck, part: Entry) -> Entry:
    """The *MAT_... card of a part; raises DeckError at the part where there is none."""
    return deck.find(*laws(), mid=part.mid, referred_by=(part, "mid"))


def law_of(material: Entry, state: str, part: Entry) -> ModuleType:
    """The module of the material's law; raises DeckError at the part if it has no law for this state of stress."""
    module = laws()[material.keyword]
    if state not in module.HISTORY:
        able = ", ".join(f"*{keyword.name}" for keyword, other in laws().items() if state in other.HISTORY)
        kind = state.replace("_", " ")
        raise part.error("mid", f"*{material.keyword.name} has no law for {kind}; these have one: {able}")
    return module
