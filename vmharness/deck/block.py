"""Text -> blocks: the data lines that follow each keyword line."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from dataclasses import field as default

from vmharness.deck.card import Card
from vmharness.deck.error import DeckError
from vmharness.deck.field import Value, shown

KEYWORD_OPTIONS = {"LONG": ("Y", "K", "S", "N"), "I10": ("N",), "MEMORY": (), "NCPU": ()}


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

    def read(self, card: Card, at: int, parameters: Mapping[str, Value]) -> list[Value]:
        """The values of data line `at` read as `card`, in the order of its fields; raises DeckError."""
        number = self.numbers[at]
        try:
            items = card.items(self.lines[at], self.long)
        except ValueError as error:
            raise self.error(str(error), number) from None
        values = []
        for (name, field), item in zip(card.fields.items(), items, strict=True):
            try:
                values.append(field.read(item, parameters))
            except ValueError as error:
                column = "unused" if name.startswith("_") else name
                value = shown(item, parameters)
                raise DeckError(str(error), self.file, number, self.name, column, value) from None
        return values

    def error(self, what: str, line: int = 0) -> DeckError:
        """What is wrong, at the keyword or at another line."""
        return DeckError(what, self.file, line or self.line, self.name)


def blocks(text: str, file: str, long: bool = False) -> Iterator[Block]:
    """The blocks of one file, up to *END; `long` is the format where *KEYWORD does not say."""
    block: Block | None = None
    tabs = "\t" in text
    for number, line in enumerate(text.removesuffix("\n").split("\n"), start=1):
        start = line[:1]
        if start == "$":
            continue
        if start == "*":
            if block is not None:
                yield block
            block = _header(line.rstrip("\r"), file, number, long)
            if block.name == "END":
                return
            if block.name == "KEYWORD":
                long = block.long
            continue
        line = line.rstrip("\r")
        if block is None:
            if line.strip():
                raise DeckError("data before the first keyword", file, number)
            continue
        if tabs and "\t" in line:
            raise block.error("a tab in a data line hides its columns; write blanks or commas", number)
        block.lines.append(line)
        block.numbers.append(number)
    if block is not None:
        yield block


def _header(line: str, file: str, number: int, long: bool) -> Block:
    """The block of a keyword line; "+" after the name makes it long, "-" standard."""
    name, _, rest = line[1:].strip().upper().partition(" ")
    if name == "KEYWORD":
        return Block(name, rest, file, number, _long(rest, long, file, number))
    if name[-1:] in ("+", "-"):
        name, rest = name[:-1], f"{name[-1]} {rest}"
    rest = rest.strip()
    if rest in ("+", "-"):
        long, rest = rest == "+", ""
    if rest:
        raise DeckError(f"unexpected text after the keyword: {rest}", file, number, name)
    return Block(name, "", file, number, long)


def _long(rest: str, long: bool, file: str, number: int) -> bool:
    """The format that *KEYWORD gives: LONG=Y and LONG=K are long, LONG=S and LONG=N standard."""
    for option in rest.split():
        name, _, value = option.partition("=")
        if name not in KEYWORD_OPTIONS:
            supported = ", ".join(KEYWORD_OPTIONS)
            raise DeckError(f"unknown option {option}; supported: {supported}", file, number, "KEYWORD")
        supported_values = KEYWORD_OPTIONS[name]
        if supported_values and value not in supported_values:
            what = f"only {', '.join(supported_values)} supported"
            raise DeckError(what, file, number, "KEYWORD", name, value)
        if name == "LONG":
            long = value in ("Y", "K")
    return long
