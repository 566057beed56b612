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

PAIRS = {f"{word}{i}": text("") for i in range(1, 5) for word in ("prmr", "val")}

PARAMETER = Keyword("PARAMETER", Card(PAIRS), repeat=True)
PARAMETER_EXPRESSION = Keyword(
    "PARAMETER_EXPRESSION", Card(prmr=text(""), expression=text(width=70)), repeat=True
)
KEYWORDS = {keyword.name: keyword for keyword in (PARAMETER, PARAMETER_EXPRESSION)}


def define(block: Block, values: dict[str, Value], replaced: Mapping[str, float]) -> None:
    """Add the parameters of a block to `values`; those of *PARAMETER that are `replaced` get new values."""
    for entry in entries(block, KEYWORDS[block.name], "", values):
        if block.name == "PARAMETER":
            for i in range(1, 5):
                _define_value(entry, f"prmr{i}", f"val{i}", values, replaced)
        else:
            _define_expression(entry, values, replaced)


def check_replaced(replaced: Mapping[str, float], values: Mapping[str, Value], file: str) -> None:
    """Raise DeckError where a parameter to replace is not in the deck."""
    for name in replaced:
        if name not in values:
            near = get_close_matches(name, values, n=3) or sorted(values)
            hint = f"; did you mean {', '.join(near)}?" if near else "; the deck has none"
            raise DeckError(f"no parameter {name} to set{hint}", file)


def _define_value(
    entry: Entry, name_field: str, field: str, values: dict[str, Value], replaced: Mapping[str, float]
) -> None:
    written = entry.values[field]
    if not entry.values[name_field]:
        if written:
            raise entry.error(field, "a value without a name")
        return
    kind, name = _name(entry, name_field, values)
    try:
        if kind == "c" and name in replaced:
            raise ValueError("is a text and cannot be set to a number")
        values[name] = _convert(kind, repr(float(replaced[name])) if name in replaced else written)
    except ValueError as error:
        if name in replaced:
            entry.values[field] = replaced[name]
        raise entry.error(field, f"parameter {name}: {error}") from None


def _define_expression(entry: Entry, values: dict[str, Value], replaced: Mapping[str, float]) -> None:
    kind, name = _name(entry, "prmr", values)
    if name in replaced:
        what = f"{name} follows from other parameters; set those instead"
        raise entry.error("expression", what)
    try:
        if kind == "c":
            raise ValueError("an expression has no text value; use *PARAMETER")
        values[name] = _convert(kind, repr(evaluate(entry.expression, values)))
    except ValueError as error:
        raise entry.error("expression", f"parameter {name}: {error}") from None


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
