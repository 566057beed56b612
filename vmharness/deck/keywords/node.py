"""*NODE: nodes and their coordinates."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CODES = tuple(range(8))  # none, x, y, z, xy, yz, zx, xyz

NODE = Keyword(
    "NODE",
    Card(
        nid=integer(width=8, above=0),
        x=real(0.0, width=16),
        y=real(0.0, width=16),
        z=real(0.0, width=16),
        tc=integer(0, width=8),
        rc=integer(0, width=8),
    ),
    table=True,
    unique="nid",
    kind="node",
)
