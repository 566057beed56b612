"""*CONTROL_PARALLEL: how many threads compute the elements."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only
from vmharness.deck.keyword import Keyword

CONTROL_PARALLEL = Keyword(
    "CONTROL_PARALLEL",
    Card(
        ncpu=integer(1, at_least=1, zero_is_default=True),
        numrhs=only(0),  # each thread has forces of its own
        const=only(2, zero_is_default=True),  # 1: the same bits however many threads
        para=only(0),
    ),
    single=True,
)
