"""*PARAMETER and *PARAMETER_EXPRESSION: names for values."""

import re
from collections.abc import Mapping
from difflib import get_close_matches

from vmharness.deck.block import Block
from vmharness.deck.card import Card
from vmharness.deck.entries import entries
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError
from vmharness.deck.expression import evaluate
from vmharness.deck.field import Value, text
from vmharness.deck.keyword import Keyword
from vmharness.deck.number import to_integer, to_real

PAIR_NAMES = [(f"prmr{i}", f"val{i}") for i in range(1, 5)]
PAIRS = {name: text("") for pair in PAIR_NAMES for name in pair}

PARAMETER = Keyword("PARAMETER", Card(PAIRS), repeat=True)
PARAMETER_EXPRESSION = Keyword(
    "PARAMETER_EXPRESSION", Card(prmr=text(""), expression=text(width=70)), repeat=True
)
KEYWORDS = {keyword.name: keyword for keyword in (PARAMETER, PARAMETER_EXPRESSION)}


def define(
    block: Block, values: dict[str, Value], replaced: Mapping[str, float], wrong: list[DeckError]
) -> None:
    """Add the parameters of a block to `values`; those of *PARAMETER that are `replaced` get new values.

    What is ill-formed is added to `wrong`; a parameter without a value is 1, so that references to it are no errors.
    """
    for entry in entries(block, KEYWORDS[block.name], "", values, wrong):
        for fields in PAIR_NAMES if block.name == "PARAMETER" else [("prmr", "expression")]:
            try:
                _define(entry, *fields, values, replaced)
            except DeckError as error:
                wrong.append(error)


def _define(
    entry: Entry, name_field: str, field: str, values: dict[str, Value], replaced: Mapping[str, float]
) -> None:
    if not entry.values[name_field] and field != "expression":
        if entry.values[field]:
            raise entry.error(field, "the name of this parameter is missing")
        return
    kind, name = _name(entry, name_field, values)
    define = _expression if field == "expression" else _value
    try:
        values[name] = define(entry, field, kind, name, values, replaced)
    except DeckError:
        values[name] = 1
        raise


def check_replaced(replaced: Mapping[str, float], values: Mapping[str, Value], file: str) -> None:
    """Raise DeckError where a parameter to replace is not in the deck."""
    for name in replaced:
        if name not in values:
            near = get_close_matches(name, values, n=3) or sorted(values)
            hint = f"; did you mean {', '.join(near)}?" if near else "; the deck has none"
            raise DeckError(f"no parameter {name} to set{hint}", file)


def _value(
    entry: Entry, field: str, kind: str, name: str, values: Mapping[str, Value], replaced: Mapping[str, float]
) -> Value:
    """The value that a card of *PARAMETER gives, or that replaces it."""
    try:
        if kind == "c" and name in replaced:
            raise ValueError("is a text and cannot be set to a number")
        return _convert(kind, repr(float(replaced[name])) if name in replaced else entry.values[field])
    except ValueError as error:
        if name in replaced:
            entry.values[field] = replaced[name]
        raise entry.error(field, f"parameter {name}: {error}") from None


def _expression(
    entry: Entry, field: str, kind: str, name: str, values: Mapping[str, Value], replaced: Mapping[str, float]
) -> Value:
    """The value of a *PARAMETER_EXPRESSION."""
    if name in replaced:
        raise entry.error(field, f"{name} follows from other parameters; set those instead")
    try:
        if kind == "c":
            raise ValueError("an expression has no text value; use *PARAMETER")
        return _convert(kind, repr(evaluate(entry.values[field], values)))
    except ValueError as error:
        raise entry.error(field, f"parameter {name}: {error}") from None


def _name(entry: Entry, field: str, values: Mapping[str, Value]) -> tuple[str, str]:
    """Type letter and name, such as "R  side": lower case, blanks between them allowed."""
    match = re.fullmatch(r"([ric]) *([a-z_][a-z0-9_]*)", entry.values[field].lower())
    if match is None:
        raise entry.error(field, "expected R, I or C (real, integer, text), then a name")
    kind, name = match.groups()
    if name in values:
        raise entry.error(field, f"parameter {name} is defined already")
    return kind, name


def _convert(kind: str, written: str) -> Value:
    if kind == "c":
        return written
    if not written:
        raise ValueError("a value is required")
    return to_integer(written) if kind == "i" else to_real(written)
