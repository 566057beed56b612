"""*CONTROL_UNITS: the units of the deck, for programs that convert it."""

from vmharness.deck.card import Card
from vmharness.deck.field import real, text
from vmharness.deck.keyword import Keyword

CONTROL_UNITS = Keyword(
    "CONTROL_UNITS",
    Card(length=text("m"), time=text("sec"), mass=text("kg"), temp=text("k")),
    Card(optional=True, length_scale=real(1.0), time_scale=real(1.0), mass_scale=real(1.0)),
    single=True,
)
