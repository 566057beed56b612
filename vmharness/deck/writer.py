"""A deck -> text in long format: includes flattened, parameters replaced by their values."""

import re
from collections.abc import Iterator
from math import isfinite
from typing import Any

from vmharness.deck.card import Card, Rows
from vmharness.deck.deck import Deck
from vmharness.deck.entry import Entry
from vmharness.deck.field import LONG_WIDTH, Field

IDS_PER_LINE = 8
NAME = re.compile(r"&\s*([A-Za-z_]\w*)")


def write_long(deck: Deck) -> str:
    """The resolved deck with 20 columns a field; `read` gives back equal entries.

    A block that was kept unread keeps its lines and their format, and the parameters to which they refer.

    A real that needs more than 20 characters is rounded to the nearest that fits: relative change
    under 1e-12, and under 1e-14 where the exponent has one digit.
    """
    lines = ["*KEYWORD LONG=Y", *_parameters(deck)]
    for entry in deck.entries:
        if entry.raw:
            lines += [f"*{entry.spelled}" + ("" if entry.raw.long else "-"), *entry.raw.lines]
        else:
            lines.append(f"*{entry.spelled}")
            lines += entry_lines(entry)
    return "\n".join([*lines, "*END", ""])


def _parameters(deck: Deck) -> list[str]:
    """A *PARAMETER block of those parameters to which the lines of unread blocks refer."""
    texts = [line for entry in deck.entries if entry.raw for line in entry.raw.lines]
    named = dict.fromkeys(name.lower() for line in texts for name in NAME.findall(line))
    kinds = {int: "I", float: "R", str: "C"}
    known = [(name, deck.parameters[name]) for name in named if name in deck.parameters]
    return ["*PARAMETER", *(f"{kinds[type(value)]} {name},{value}" for name, value in known)] if known else []


def entry_lines(entry: Entry) -> Iterator[str]:
    """The data lines of one entry; cards that were not read are not written."""
    for card in entry.keyword.group(entry.suffix):
        if card.when and not card.when(entry):
            continue  # its fields may stand on a card that is there instead
        kept = [name for name in card.fields if name[0] != "_"]
        if not kept or any(name in entry.lines for name in kept):
            yield card_line(card, entry.values)
    cards = entry.keyword.rows
    if not cards:
        return
    if isinstance(cards[0], Rows) and cards[0].flat:
        ids = entry.values[cards[0].flat]
        for i in range(0, len(ids), IDS_PER_LINE):
            yield "".join(f"{value:{LONG_WIDTH}d}" for value in ids[i : i + IDS_PER_LINE])
        return
    columns = {name: entry.values[name].tolist() for card in cards for name in card.fields if name[0] != "_"}
    for row in range(len(next(iter(columns.values())))):
        values = {name: column[row] for name, column in columns.items()}
        for card in cards:
            yield card_line(card, values)


def card_line(card: Card, values: dict[str, Any]) -> str:
    """One card in long format; unused columns are blank."""
    items = [_item(field, values.get(name, "")) for name, field in card.fields.items()]
    line = "".join(items).rstrip()
    return f" {line}" if line[:1] in ("$", "*") else line  # a heading must not become a comment or keyword


def _item(field: Field, value: int | float | str) -> str:
    width = field.columns(long=True)
    if isinstance(value, str):
        return value.ljust(width)
    return (number(value) if isinstance(value, float) else str(value)).rjust(width)


def number(value: float) -> str:
    """The shortest text that gives `value`, or the nearest number with the most digits that fit.

    >>> number(0.1), number(-1.2345678901234567e-10)
    ('0.1', '-1.2345678901235e-10')
    """
    if len(exact := repr(value)) <= LONG_WIDTH:
        return exact
    for digits in range(17, 1, -1):
        text = f"{value:.{digits}e}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")
        if len(text) <= LONG_WIDTH and isfinite(float(text)):  # near the largest double, rounding overflows
            exact = repr(float(text))
            return exact if len(exact) <= LONG_WIDTH else text
    raise ValueError(value)
