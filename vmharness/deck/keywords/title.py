"""*TITLE: the name of the problem."""

from vmharness.deck.card import Card
from vmharness.deck.field import text
from vmharness.deck.keyword import Keyword

TITLE = Keyword("TITLE", Card(title=text("", width=80)), single=True)
