"""Rows of a table -> one array a field, quickly where nothing is unusual."""

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.deck.block import Block
from vmharness.deck.card import Card, Rows, line_end
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError
from vmharness.deck.field import Field, Value
from vmharness.deck.keyword import Keyword

PLAIN = re.compile(r"[0-9eE+\-. ]*")  # no comma, no &, no D exponent, no word
DTYPES = {"integer": np.int64, "real": np.float64, "text": np.str_}


def read_rows(
    entry: Entry, block: Block, lines: range, parameters: Mapping[str, Value], wrong: list[DeckError]
) -> None:
    """Read `lines` of `block` as rows of the keyword's row cards into arrays of `entry`.

    A row may take several lines, one a card. A blank line among them is refused: it would be a row of zeros. What is
    ill-formed is added to `wrong`; DeckError is raised where the rows cannot be told apart.
    """
    if not lines:
        raise block.error("no data")
    cards = row_cards(entry.keyword, block.lines[lines[0]], block.long)
    if len(lines) % len(cards):
        raise block.error(
            f"a row takes {len(cards)} lines; the last one is incomplete", block.numbers[lines[-1]]
        )
    for first, card in enumerate(cards):
        chosen = lines[first :: len(cards)]
        numbers = block.numbers[chosen.start : chosen.stop : chosen.step]
        columns = fast_columns(card, block.lines[chosen.start : chosen.stop : chosen.step], block.long)
        if columns is None:
            columns = careful_columns(card, block, chosen, parameters, wrong)
            for row, at in enumerate(chosen):
                entry.references |= block.references(card, at, parameters, row)
        if isinstance(card, Rows) and card.flat:
            ids = np.stack(columns, axis=1)
            pairs = ids.reshape(len(ids), -1, card.together)
            kept = (pairs != 0).any(axis=2).repeat(card.together, axis=1)
            if not kept.any():
                raise block.error("no ids", numbers[0])
            entry.values[card.flat] = ids[kept]
            entry.lines[card.flat] = np.repeat(numbers, kept.sum(axis=1)).tolist()
            continue
        for name, column in zip(card.fields, columns, strict=True):
            if name[0] != "_":
                entry.values[name] = column
                entry.lines[name] = numbers
    if cards is not entry.keyword.rows:
        absent = {name: default for card in entry.keyword.rows for name, default in card.defaults().items()}
        for name in absent.keys() - entry.values.keys():
            entry.values[name] = np.full(len(lines), absent[name])


def row_cards(keyword: Keyword, first: str, long: bool) -> tuple[Card, ...]:
    """The cards of one row: the keyword's own, or its `one_line` where the first line is too long for their first."""
    if keyword.one_line is None:
        return keyword.rows
    try:
        keyword.rows[0].items(first, long)
    except ValueError:
        return (keyword.one_line,)
    return keyword.rows


def careful_columns(
    card: Card, block: Block, lines: range, parameters: Mapping[str, Value], wrong: list[DeckError]
) -> list[NDArray[Any]]:
    """One array a field, read field by field: any format, any number, exact errors.

    Of errors that are alike but for the row, the first is added to `wrong`, with their number.
    """
    for at in lines:
        if not block.lines[at].strip():
            raise block.error("a blank line among the rows of a table", block.numbers[at])
    found: list[DeckError] = []
    rows = [block.read(card, at, parameters, found) for at in lines]
    wrong += first_of_alike(found)
    columns = zip(card.fields.values(), zip(*rows, strict=True), strict=True)
    return [np.array(column, dtype=DTYPES[field.kind]) for field, column in columns]


def first_of_alike(errors: Sequence[DeckError]) -> list[DeckError]:
    """The first error of each field and kind, saying how many rows more have it."""
    kinds: dict[tuple[str, str], list[DeckError]] = {}
    for error in errors:
        kinds.setdefault((error.field, error.what), []).append(error)
    for first, *others in kinds.values():
        if others:
            first.what += f" ({1 + len(others)} such rows)"
    return [alike[0] for alike in kinds.values()]


def fast_columns(card: Card, texts: Sequence[str], long: bool) -> list[NDArray[Any]] | None:
    """The same, a column at a time, or None where anything at all needs care."""
    fields = list(card.fields.values())
    widths = [field.columns(long) for field in fields]
    total = sum(widths)
    if any(field.kind == "text" for field in fields):
        return None
    end = line_end(long)
    if any(line[total:end].strip() or not line.strip() for line in texts):
        return None
    joined = "".join([line[:total].ljust(total) for line in texts])
    if not PLAIN.fullmatch(joined):
        return None
    table = np.frombuffer(joined.encode("ascii"), dtype=[(str(i), f"S{w}") for i, w in enumerate(widths)])
    columns = []
    for i, field in enumerate(fields):
        column = fast_column(field, table[str(i)])
        if column is None:
            return None
        columns.append(column)
    return columns


def fast_column(field: Field, characters: NDArray[np.bytes_]) -> NDArray[Any] | None:
    """Numbers of one column of fixed width, or None where a value needs care."""
    blank = np.char.strip(characters) == b""
    if blank.any():
        if field.default is None:
            return None
        characters = np.where(blank, str(field.default).encode(), characters)
    try:
        values: NDArray[Any] = characters.astype(DTYPES[field.kind])
    except (ValueError, OverflowError):
        return None
    if field.zero_is_default and field.default is not None:
        values[values == 0] = field.default
    fine = (
        bool(np.isfinite(values).all())
        and (field.above is None or bool((values > field.above).all()))
        and not (field.unused and values.any())
    )
    return values if fine else None
