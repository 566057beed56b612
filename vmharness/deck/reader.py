"""A file -> a deck: every field of every known keyword read, or all that is ill-formed with its lines."""

from collections.abc import Mapping
from pathlib import Path

from vmharness.deck import parameter
from vmharness.deck.block import BEGINNINGS, Block
from vmharness.deck.deck import Deck
from vmharness.deck.entries import entries
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError, refuse
from vmharness.deck.field import Value
from vmharness.deck.keyword import Keyword
from vmharness.deck.source import Source
from vmharness.deck.unique import first_of_single, repeated

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
    `text` is read in place of the file at `path`, if given. A keyword that is not in `vocabulary` is kept as it stands.

    Raises DeckError, with file and line, for anything that is ill-formed; DeckErrors where there are several things.
    """
    deck, wrong = read_all(path, vocabulary, parameters, include_outside, text)
    refuse(wrong)
    return deck


def read_all(
    path: str | Path,
    vocabulary: Vocabulary,
    parameters: Mapping[str, float] | None = None,
    include_outside: bool = False,
    text: str = "",
) -> tuple[Deck, list[DeckError]]:
    """Like `read`, but what is ill-formed has stand-ins in the deck, and is returned with it."""
    path = Path(path)
    replaced = {name.lower(): value for name, value in (parameters or {}).items()}
    values: dict[str, Value] = {}
    found: list[Entry] = []
    notes: dict[str, None] = {}  # in order, each once
    wrong: list[DeckError] = []
    source = Source(path, include_outside, wrong, text)
    try:
        for block in source.blocks():
            if block.name in BEGINNINGS:
                notes.update(_keyword_notes(block))
            elif block.name in parameter.KEYWORDS:
                parameter.define(block, values, replaced, wrong)
            else:
                found += _entries(block, vocabulary, values, wrong)
        parameter.check_replaced(replaced, values, path.name)
    except DeckError as error:
        wrong.append(error)
    found = first_of_single(found, wrong)
    wrong += repeated(found)
    return Deck(path, found, values, list(notes), source.files, not wrong), wrong


def _entries(
    block: Block, vocabulary: Vocabulary, values: Mapping[str, Value], wrong: list[DeckError]
) -> list[Entry]:
    try:
        return entries(block, *lookup(block, vocabulary), values, wrong)
    except DeckError as error:
        wrong.append(error)
        return []


def lookup(block: Block, vocabulary: Vocabulary) -> tuple[Keyword, str]:
    """The keyword of a block and its option ("TITLE", "ID", ... or none); one without cards if it is not known.

    Raises DeckError for a kind of *PARAMETER that is not known.
    """
    if block.name in vocabulary:
        return vocabulary[block.name], ""
    base, _, option = block.name.rpartition("_")
    if base in vocabulary and option in vocabulary[base].options:
        return vocabulary[base], option
    if block.name.startswith("PARAMETER"):
        raise block.error("unknown keyword")  # what refers to its parameters could not be read
    return Keyword(block.name), ""


def _keyword_notes(block: Block) -> dict[str, None]:
    asked = [option for option in block.rest.split() if not option.startswith(("LONG", "I10"))]
    return {f"*KEYWORD: {option} cannot change results.": None for option in asked}
