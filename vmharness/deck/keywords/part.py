"""*PART: what elements share: section, material, hourglass control."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, text
from vmharness.deck.keyword import Keyword

PART = Keyword(
    "PART",
    Card(heading=text("", width=70)),
    Card(
        pid=integer(above=0),
        secid=integer(above=0),
        mid=integer(above=0),
        eosid=only(0),
        hgid=integer(0, at_least=0),
        grav=only(0),
        adpopt=only(0),
        tmid=only(0),
    ),
    repeat=True,
    unique="pid",
    kind="part",
)
