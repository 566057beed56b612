"""*CONTROL_TIMESTEP: how large the time step may be."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

CONTROL_TIMESTEP = Keyword(
    "CONTROL_TIMESTEP",
    Card(
        dtinit=real(0.0, at_least=0.0),
        tssfac=real(0.9, zero_is_default=True, above=0.0),
        isdo=integer(0, choices=(0, 1, 2)),
        tslimt=only(0.0),
        dt2ms=real(0.0),
        lctm=integer(0, at_least=0),
        erode=only(0),
        ms1st=integer(0, choices=(0, 1)),
    ),
    single=True,
)
