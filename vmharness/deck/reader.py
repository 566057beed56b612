"""A file -> a deck: every keyword known, every field checked, or an error with its line."""

from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path

from vmharness.deck import parameter
from vmharness.deck.block import Block
from vmharness.deck.deck import Deck
from vmharness.deck.entries import entries
from vmharness.deck.entry import Entry
from vmharness.deck.field import Value
from vmharness.deck.keyword import Keyword
from vmharness.deck.source import Source
from vmharness.deck.unique import check_unique

Vocabulary = Mapping[str, Keyword]


def read(
    path: str | Path,
    vocabulary: Vocabulary,
    parameters: Mapping[str, float] | None = None,
    include_outside: bool = False,
    text: str = "",
) -> Deck:
    """Read a deck in LS-DYNA keyword format; fixed, comma and long format, line by line.

    `parameters` replace values of *PARAMETER (names in any case) at full precision, before any
    *PARAMETER_EXPRESSION is evaluated. Files outside the deck's folder are included only if
    `include_outside`. Parameters count from their definition on, as in LS-DYNA.
    `text` is read in place of the file at `path`, if given.

    Raises DeckError, with file and line, for anything that is wrong or not in `vocabulary`.
    """
    path = Path(path)
    replaced = {name.lower(): value for name, value in (parameters or {}).items()}
    values: dict[str, Value] = {}
    found: list[Entry] = []
    notes: dict[str, None] = {}  # in order, each once
    source = Source(path, include_outside, text)
    for block in source.blocks():
        if block.name == "KEYWORD":
            notes.update(_keyword_notes(block))
        elif block.name in parameter.KEYWORDS:
            parameter.define(block, values, replaced)
        else:
            keyword, option = lookup(block, vocabulary)
            found += entries(block, keyword, option, values)
            if keyword.effect:
                notes[f"*{keyword.name}: {keyword.effect}"] = None
    parameter.check_replaced(replaced, values, path.name)
    check_unique(found)
    return Deck(path, found, values, list(notes), source.files)


def lookup(block: Block, vocabulary: Vocabulary) -> tuple[Keyword, str]:
    """The keyword of a block and its option ("TITLE", "ID", ... or none)."""
    if block.name in vocabulary:
        return vocabulary[block.name], ""
    base, _, option = block.name.rpartition("_")
    if base in vocabulary and option in vocabulary[base].options:
        return vocabulary[base], option
    known = sorted({name for keyword in vocabulary.values() for name in keyword.names()})
    near = get_close_matches(block.name, known, n=1, cutoff=0.75)
    raise block.error("unknown keyword" + (f"; did you mean *{near[0]}?" if near else ""))


def _keyword_notes(block: Block) -> dict[str, None]:
    asked = [option for option in block.rest.split() if option.startswith(("MEMORY", "NCPU"))]
    return {f"*KEYWORD: {option} cannot change results.": None for option in asked}
