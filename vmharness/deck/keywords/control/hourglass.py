"""*CONTROL_HOURGLASS: hourglass control of parts without their own."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_HOURGLASS = Keyword(
    "CONTROL_HOURGLASS",
    Card(
        ihq=integer(0),
        qh=real(0.1, zero_is_default=True),
    ),
    single=True,
)
