"""LS-DYNA keyword decks: text -> typed entries; knows no mechanics."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.deck import Deck
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError
from vmharness.deck.field import integer, only, real, skip, text
from vmharness.deck.keyword import Keyword
from vmharness.deck.reader import read
from vmharness.deck.vocabulary import vocabulary
from vmharness.deck.writer import write_long

__all__ = [
    "Card",
    "Deck",
    "DeckError",
    "Entry",
    "Keyword",
    "Rows",
    "integer",
    "only",
    "read",
    "real",
    "skip",
    "text",
    "vocabulary",
    "write_long",
]
