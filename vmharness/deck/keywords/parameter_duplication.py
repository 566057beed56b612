"""*PARAMETER_DUPLICATION: what a parameter that is defined again does."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

PARAMETER_DUPLICATION = Keyword("PARAMETER_DUPLICATION", Card(dflag=integer(1)))
