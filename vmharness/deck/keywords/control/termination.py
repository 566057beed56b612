"""*CONTROL_TERMINATION: when a run ends."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_TERMINATION = Keyword(
    "CONTROL_TERMINATION",
    Card(
        endtim=real(),
        endcyc=integer(0),
        dtmin=real(0.0),  # factor on the first time step
        endeng=real(0.0),
        endmas=real(1.0e8),
        nosol=integer(0),
    ),
    single=True,
)
