"""A block -> entries: its lines read as the keyword's layout says."""

from collections.abc import Mapping

from vmharness.deck.block import Block
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError
from vmharness.deck.field import Value
from vmharness.deck.keyword import Keyword
from vmharness.deck.table import read_rows


def entries(
    block: Block, keyword: Keyword, option: str, parameters: Mapping[str, Value], wrong: list[DeckError]
) -> list[Entry]:
    """The entries of a block; what is ill-formed is added to `wrong`, and has stand-ins.

    A blank line is a card of defaults where a card must come. Blank lines after the last group end the block:
    they begin no group, no optional card and no row.
    """
    if not keyword.cards and not keyword.rows:
        return [Entry(keyword, block.name, block.file, block.line, option, raw=block)]
    found: list[Entry] = []
    try:
        _read_groups(found, block, keyword, option, parameters, wrong)
    except DeckError as error:
        wrong.append(error)
    return found


def _read_groups(
    found: list[Entry],
    block: Block,
    keyword: Keyword,
    option: str,
    parameters: Mapping[str, Value],
    wrong: list[DeckError],
) -> None:
    """Add the entries of a block to `found`; raises DeckError where its lines are too many or too few."""
    end = len(block.lines)
    while end and not block.lines[end - 1].strip():
        end -= 1
    at = 0
    while not found or (keyword.repeat and at < end):
        entry = Entry(keyword, block.name, block.file, block.line, option)
        for card in keyword.options.values():
            entry.values.update(card.defaults())
        at = _read_group(entry, block, at, end, parameters, wrong)
        found.append(entry)
    if keyword.rows:
        read_rows(found[-1], block, range(at, end), parameters, wrong)
    elif at < end:
        count = "one line" if at == 1 else f"{at} lines"
        first = next(i for i in range(at, end) if block.lines[i].strip())
        raise block.error(f"one line too many: this keyword has {count} here", block.numbers[first])


def _read_group(
    entry: Entry, block: Block, at: int, end: int, parameters: Mapping[str, Value], wrong: list[DeckError]
) -> int:
    """Read the cards of one group from line `at` on; returns the line after them."""
    for number, card in enumerate(entry.keyword.group(entry.suffix), start=1):
        if (card.when and not card.when(entry)) or (card.optional and at >= end):
            entry.values = card.defaults() | entry.values  # a field may stand on a card that is there instead
            continue
        if at >= len(block.lines):
            fields = ", ".join(card.defaults()).upper()
            raise block.error(f"card {number} is missing ({fields})", (block.numbers or [block.line])[-1])
        for name, value in zip(card.fields, block.read(card, at, parameters, wrong), strict=True):
            if name[0] != "_":
                entry.values[name] = value
                entry.lines[name] = block.numbers[at]
        entry.references |= block.references(card, at, parameters)
        at += 1
    return at
