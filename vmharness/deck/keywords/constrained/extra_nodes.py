"""*CONSTRAINED_EXTRA_NODES_NODE and _SET: further nodes of a rigid part, wherever they lie."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

CONSTRAINED_EXTRA_NODES_NODE = Keyword(
    "CONSTRAINED_EXTRA_NODES_NODE",
    Card(pid=integer(above=0), nid=integer(above=0), iflag=integer(0)),
    repeat=True,
)
CONSTRAINED_EXTRA_NODES_SET = Keyword(
    "CONSTRAINED_EXTRA_NODES_SET",
    Card(pid=integer(above=0), nsid=integer(above=0), iflag=integer(0)),
    repeat=True,
)
