"""*SECTION_DISCRETE: whether springs and dampers act along their axis or about it."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only
from vmharness.deck.keyword import Keyword

SECTION_DISCRETE = Keyword(
    "SECTION_DISCRETE",
    Card(
        secid=integer(above=0),
        dro=integer(0, choices=(0, 1)),
        kd=only(0.0),
        v0=only(0.0),
        cl=only(0.0),
        fd=only(0.0),
    ),
    Card(cdl=only(0.0), tdl=only(0.0)),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
