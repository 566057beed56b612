"""*COMMENT: words, kept as they stand."""

from vmharness.deck.keyword import Keyword

COMMENT = Keyword("COMMENT")
