"""*DEFINE_SD_ORIENTATION: a direction, fixed in space, for springs and dampers."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

DEFINE_SD_ORIENTATION = Keyword(
    "DEFINE_SD_ORIENTATION",
    Card(
        vid=integer(above=0),
        iop=only(0),
        xt=real(0.0),
        yt=real(0.0),
        zt=real(0.0),
        nid1=only(0),
        nid2=only(0),
    ),
    repeat=True,
    options=("TITLE",),
    unique="vid",
    kind="orientation of springs and dampers",
)
