"""*CONTROL_BULK_VISCOSITY: viscosity of solids in shocks (other elements have none)."""

from vmharness.deck.card import Card
from vmharness.deck.field import only, real
from vmharness.deck.keyword import Keyword

CONTROL_BULK_VISCOSITY = Keyword(
    "CONTROL_BULK_VISCOSITY",
    Card(
        q1=real(1.5, at_least=0.0),
        q2=real(0.06, at_least=0.0),
        type=only(1, zero_is_default=True),
        btype=only(0),
        tstype=only(0),
    ),
    single=True,
)
