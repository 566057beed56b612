"""*MAT_RIGID (020): the part is one rigid body, so it has no stress and no kernel. E and PR serve contact alone.

CMO = 1 constrains the translation of the centre and the rotation of the body along global axes, as CON1 and CON2 say.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.rule import above, among, between, no_effect, only, where
from vmharness.deck.support import supports
from vmharness.explicit.materials.elastic import density, moduli

FREE = where(lambda entry: entry.cmo == 0, "CMO = 0 holds nothing")

SUPPORTS = (
    supports(
        MAT_RIGID,
        ro=above(0.0),
        e=above(0.0),
        pr=between(-1.0, 0.5),
        **{name: only(0.0) for name in ("n", "couple", "m")},
        alias=no_effect("title"),
        cmo=among(0, 1),
        **{name: among(*range(8), idle=FREE) for name in ("con1", "con2")},
        spcnid=only(0),
        **{name: only(0.0) for name in ("xspc", "yspc", "zspc")},
        **{name: no_effect("affects output only") for name in ("lco", "a2", "a3", "v1", "v2", "v3")},
        bndlco=only(0),
    ),
)

__all__ = ["CHANNELS", "HISTORY", "KEYWORD", "constants", "density", "moduli"]

KEYWORD = MAT_RIGID
HISTORY: dict[str, int] = {}
CHANNELS: dict[str, int] = {}


def constants(deck: Deck, entry: Entry) -> tuple[()]:
    """None, since there is no kernel."""
    return ()
