"""*CONTROL_SOLUTION: whether the analysis is of structures, of heat, or of both."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

CONTROL_SOLUTION = Keyword(
    "CONTROL_SOLUTION",
    Card(
        soln=integer(0),
        nlq=integer(0),
        isnan=integer(0),
        lcint=integer(100, zero_is_default=True),
        lcacc=integer(0),
        ncdcf=integer(1, zero_is_default=True),
        nocop=integer(0),
    ),
    single=True,
)
