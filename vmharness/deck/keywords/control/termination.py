"""*CONTROL_TERMINATION: when a run ends."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

CONTROL_TERMINATION = Keyword(
    "CONTROL_TERMINATION",
    Card(
        endtim=real(above=0.0),
        endcyc=integer(0, at_least=0),
        dtmin=real(0.0, at_least=0.0),  # factor on the first time step
        endeng=only(0.0),
        endmas=real(1.0e8, choices=(0.0, 1.0e8)),
        nosol=only(0),
    ),
    single=True,
)
