"""*ELEMENT_DISCRETE: a spring or damper between two nodes, or between a node and the ground."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

ELEMENT_DISCRETE = Keyword(
    "ELEMENT_DISCRETE",
    Card(
        eid=integer(width=8, above=0),
        pid=integer(width=8, above=0),
        n1=integer(width=8, above=0),
        n2=integer(0, width=8),  # 0 is the ground
        vid=integer(0, width=8),
        s=real(1.0, width=16, zero_is_default=True),
        pf=integer(0, width=8),  # what is printed
        offset=real(0.0, width=16),
    ),
    table=True,
    unique="eid",
    kind="discrete element",
    corners=("n1", "n2"),
)
