"""*CONSTRAINED_RIGID_BODIES: a rigid part that joins another, to be one body under the other's number."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

CONSTRAINED_RIGID_BODIES = Keyword(
    "CONSTRAINED_RIGID_BODIES",
    Card(pidl=integer(above=0), pidc=integer(above=0), iflag=integer(0)),
    repeat=True,
    unique="pidc",
    kind="merged rigid body",
)
