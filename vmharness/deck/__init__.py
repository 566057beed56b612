"""LS-DYNA keyword decks: text -> typed entries; knows no mechanics."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.deck import Deck
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError, DeckErrors
from vmharness.deck.field import integer, real, skip, text
from vmharness.deck.finding import Finding
from vmharness.deck.keyword import Keyword
from vmharness.deck.reader import read, read_all
from vmharness.deck.vocabulary import vocabulary
from vmharness.deck.writer import write_long

__all__ = [
    "Card",
    "Deck",
    "DeckError",
    "DeckErrors",
    "Entry",
    "Finding",
    "Keyword",
    "Rows",
    "integer",
    "read",
    "read_all",
    "real",
    "skip",
    "text",
    "vocabulary",
    "write_long",
]
