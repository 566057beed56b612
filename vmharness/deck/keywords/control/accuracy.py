"""*CONTROL_ACCURACY: objective stress update and node numbering."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only
from vmharness.deck.keyword import Keyword

CONTROL_ACCURACY = Keyword(
    "CONTROL_ACCURACY",
    Card(
        osu=integer(0, choices=(0, 1)),
        inn=only(1, zero_is_default=True),
        pidos=only(0),
        iacc=only(0),
        exacc=only(0.0),
        srtflg=integer(0, choices=(0, 1)),
    ),
    single=True,
    effect="the stress update is always of second order (OSU = 1).",
)
