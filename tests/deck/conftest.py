"""Decks written as text in tests."""

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from vmharness.deck import Deck, Keyword, read, vocabulary

VOCABULARY = vocabulary("vmharness.deck.keywords")


@pytest.fixture
def deck(tmp_path: Path) -> Callable[..., Deck]:
    """Read the data blocks of a deck: `deck("*NODE\\n...")`; *KEYWORD goes before them."""

    def from_text(
        text: str,
        first: str = "*KEYWORD\n",
        known: Mapping[str, Keyword] = VOCABULARY,
        parameters: Mapping[str, float] | None = None,
    ) -> Deck:
        path = tmp_path / "deck.k"
        path.write_bytes((first + text).encode())
        return read(path, known, parameters)

    return from_text
