"""*CONTROL_PARALLEL: how many threads compute the elements."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

CONTROL_PARALLEL = Keyword(
    "CONTROL_PARALLEL",
    Card(
        ncpu=integer(1, zero_is_default=True),
        numrhs=integer(0),
        const=integer(2, zero_is_default=True),  # 1: the same bits however many threads, 2: not
        para=integer(0),
    ),
    single=True,
)
