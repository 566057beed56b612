"""*DEFINE_SD_ORIENTATION: a direction for springs and dampers, fixed in space or between two nodes."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

DEFINE_SD_ORIENTATION = Keyword(
    "DEFINE_SD_ORIENTATION",
    Card(
        vid=integer(above=0),
        iop=integer(0),
        xt=real(0.0),
        yt=real(0.0),
        zt=real(0.0),
        nid1=integer(0),
        nid2=integer(0),
    ),
    repeat=True,
    options=("TITLE",),
    unique="vid",
    kind="orientation of springs and dampers",
)
