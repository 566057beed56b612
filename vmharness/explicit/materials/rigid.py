"""*MAT_RIGID: the part is one rigid body. E and PR serve contact alone; there is no law, for there is no stress.

CMO = 1 holds the body's centre and its rotations in global directions: CON1 and CON2 are codes like those of *NODE.
"""

from vmharness.deck import Card, Deck, Entry, Keyword
from vmharness.deck.field import integer, only, real, text
from vmharness.deck.keywords.node import CODES

KEYWORD = Keyword(
    "MAT_RIGID",
    Card(
        mid=integer(above=0),
        ro=real(above=0.0),
        e=real(above=0.0),
        pr=real(0.0),
        n=only(0.0),
        couple=only(0.0),
        m=only(0.0),
        alias=text(""),
    ),
    Card(
        cmo=integer(0, choices=(0, 1)),
        con1=integer(0, choices=CODES),
        con2=integer(0, choices=CODES),
        spcnid=only(0),
        xspc=only(0.0),
        yspc=only(0.0),
        zspc=only(0.0),
    ),
    Card(lco=real(0.0), a2=real(0.0), a3=real(0.0), v1=real(0.0), v2=real(0.0), v3=real(0.0), bndlco=only(0)),
    aliases=("MAT_020",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)

HISTORY: dict[str, int] = {}


def constants(deck: Deck, entry: Entry) -> tuple[float, float]:
    """Young's modulus E and Poisson's ratio, for contact; raises DeckError unless -1 < PR < 1/2."""
    if not -1.0 < entry.pr < 0.5:
        raise entry.error("pr", "must lie between -1 and 0.5")
    return entry.e, entry.pr
