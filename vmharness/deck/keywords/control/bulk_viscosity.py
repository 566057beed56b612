"""*CONTROL_BULK_VISCOSITY: viscosity of solids in shocks (other elements have none)."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_BULK_VISCOSITY = Keyword(
    "CONTROL_BULK_VISCOSITY",
    Card(
        q1=real(1.5),
        q2=real(0.06),
        type=integer(1, zero_is_default=True),
        btype=integer(0),
        tstype=integer(0),
    ),
    single=True,
)
