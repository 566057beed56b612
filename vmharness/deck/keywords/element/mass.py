"""*ELEMENT_MASS: lumped mass at a node."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

ELEMENT_MASS = Keyword(
    "ELEMENT_MASS",
    Card(
        eid=integer(width=8, above=0),
        nid=integer(width=8, above=0),
        mass=real(0.0, width=16),
        pid=integer(0, width=8),
    ),
    table=True,
    unique="eid",
    kind="mass element",
)
