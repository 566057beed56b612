"""*CONTROL_ACCURACY: objective stress update and node numbering."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_ACCURACY = Keyword(
    "CONTROL_ACCURACY",
    Card(
        osu=integer(0),
        inn=integer(1, zero_is_default=True),
        pidos=integer(0),
        iacc=integer(0),
        exacc=real(0.0),
        srtflg=integer(0),
    ),
    single=True,
)
