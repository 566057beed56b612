"""Text -> blocks: the data lines that follow each keyword line."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from dataclasses import field as default

from vmharness.deck.card import Card
from vmharness.deck.error import DeckError
from vmharness.deck.field import REFERENCE, Value, shown

BEGINNINGS = ("KEYWORD", "KEYWORD_ID")  # the second has a line: names of the project and the run
KEYWORD_OPTIONS = {
    "LONG": ("Y", "K", "S", "N"),
    "I10": ("N",),
    **dict.fromkeys(("MEMORY", "MEMORY2", "NCPU", "JOBID", "PROJECT", "NUM", "STAGE"), ()),
}
MEMORY = re.compile(r"[0-9]+[KMG]?")  # words of memory
COMMENT = "COMMENT"  # may have its words on the keyword line


@dataclass(frozen=True, slots=True)
class Block:
    """A keyword line and its data lines, without comments."""

    name: str  # in capitals, without the star
    rest: str  # what follows the name on the keyword line
    file: str
    line: int
    long: bool  # 20 columns a field
    lines: list[str] = default(default_factory=list)
    numbers: list[int] = default(default_factory=list)  # line numbers of `lines`

    def read(
        self, card: Card, at: int, parameters: Mapping[str, Value], wrong: list[DeckError]
    ) -> list[Value]:
        """The values of data line `at` read as `card`, in the order of its fields.

        What is ill-formed is added to `wrong`, and has a stand-in.
        """
        number = self.numbers[at]
        try:
            items = card.items(self.lines[at], self.long)
        except ValueError as error:
            wrong.append(self.error(str(error), number))
            return [field.stand_in for field in card.fields.values()]
        values = []
        for (name, field), item in zip(card.fields.items(), items, strict=True):
            try:
                values.append(field.read(item, parameters))
            except ValueError as error:
                column = "unused" if name.startswith("_") else name
                value = shown(item, parameters)
                wrong.append(DeckError(str(error), self.file, number, self.name, column, value))
                values.append(field.stand_in)
        return values

    def references(
        self, card: Card, at: int, parameters: Mapping[str, Value], row: int | None = None
    ) -> dict[tuple[str, int | None], str]:
        """The fields of a well-formed data line `at`, read as `card`, that name a parameter: its name and its value."""
        if "&" not in self.lines[at]:
            return {}
        try:
            items = card.items(self.lines[at], self.long)
        except ValueError:
            return {}
        named = zip(card.fields, items, strict=True)
        return {
            (name, row): shown(text, parameters) for name, text in named if REFERENCE.fullmatch(text.strip())
        }

    def error(self, what: str, line: int = 0) -> DeckError:
        """What is wrong, at the keyword or at another line."""
        return DeckError(what, self.file, line or self.line, self.name)


def blocks(text: str, file: str, long: bool, wrong: list[DeckError]) -> Iterator[Block]:
    """The blocks of one file, up to *END; `long` is the format where *KEYWORD does not say.

    What is ill-formed is added to `wrong`.
    """
    block: Block | None = None
    for number, line in enumerate(text.removesuffix("\n").split("\n"), start=1):
        start = line[:1]
        if start == "$":
            continue
        if start == "*":
            if block is not None:
                yield block
            block = _header(line.rstrip("\r"), file, number, long, wrong)
            if block.name == "END":
                return
            if block.name in BEGINNINGS:
                long = block.long
            continue
        line = line.rstrip("\r")
        if block is None:
            if line.strip():
                raise DeckError("data before the first keyword", file, number)
            continue
        block.lines.append(line)
        block.numbers.append(number)
    if block is not None:
        yield block


def _header(line: str, file: str, number: int, long: bool, wrong: list[DeckError]) -> Block:
    """The block of a keyword line; "+" after the name makes it long, "-" standard. Words in brackets are a comment."""
    name, _, rest = line[1:].partition("(")[0].strip().upper().partition(" ")
    if name in BEGINNINGS:
        return Block(name, rest, file, number, _long(rest, long, Block(name, "", file, number, long), wrong))
    if name[-1:] in ("+", "-"):
        name, rest = name[:-1], f"{name[-1]} {rest}"
    rest = rest.strip()
    if rest in ("+", "-"):
        long, rest = rest == "+", ""
    if rest and name != COMMENT:
        wrong.append(DeckError(f"unexpected text after the keyword: {rest}", file, number, name))
    if not name:
        wrong.append(DeckError("unknown keyword", file, number))
    return Block(name, "", file, number, long)


def _long(rest: str, long: bool, block: Block, wrong: list[DeckError]) -> bool:
    """The format that *KEYWORD gives: LONG=Y and LONG=K are long, LONG=S and LONG=N standard."""
    for option in rest.split():
        name, _, value = option.partition("=")
        if MEMORY.fullmatch(option):
            continue
        if name not in KEYWORD_OPTIONS:
            supported = ", ".join(KEYWORD_OPTIONS)
            wrong.append(block.error(f"unknown option {option}; supported: {supported}"))
            continue
        supported_values = KEYWORD_OPTIONS[name]
        if supported_values and value not in supported_values:
            what = f"only {', '.join(supported_values)} supported"
            wrong.append(DeckError(what, block.file, block.line, block.name, name, value))
        if name == "LONG":
            long = value in ("Y", "K")
    return long
