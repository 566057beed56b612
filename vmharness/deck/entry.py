"""An entry: one group of cards of a keyword, or one table, as typed values with their places in the deck."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from vmharness.deck.block import Block
from vmharness.deck.error import DeckError
from vmharness.deck.keyword import Keyword


@dataclass(slots=True, eq=False)
class Entry:
    """Values of a group of cards as attributes by field name; those of rows are arrays, one value a row."""

    keyword: Keyword
    spelled: str  # the keyword as the deck has it, option and alias included
    file: str
    line: int  # of the keyword
    suffix: str = ""  # the option: "TITLE", "ID", ...
    values: dict[str, Any] = field(default_factory=dict)
    lines: dict[str, int | Sequence[int]] = field(default_factory=dict)  # of the fields that were read
    # Fields, and rows of tables, that name a parameter: its name and value, as "&rho (7.8)".
    references: dict[tuple[str, int | None], str] = field(default_factory=dict)
    raw: Block | None = None  # the block as it stands in the deck, where it was not read

    @classmethod
    def of_defaults(cls, keyword: Keyword) -> "Entry":
        """An entry that stands in no deck: every field has its default, and is written with the entry."""
        values = {name: value for card in keyword.cards for name, value in card.defaults().items()}
        return cls(keyword, keyword.name, "", 0, values=values, lines=dict.fromkeys(values, 0))

    def __getattr__(self, name: str) -> Any:
        """The value of a field: a number or a text, or an array for a field of rows."""
        if name.startswith("__"):
            raise AttributeError(name)
        try:
            return self.values[name]
        except KeyError:
            raise AttributeError(f"{self.keyword!r} has no field {name}") from None

    def line_of(self, field: str, row: int | None = None) -> int:
        """The line that gives `field` (in row `row` of a table), or the keyword's line if none does."""
        line = self.lines.get(field, self.line)
        if isinstance(line, int):
            return line
        return self.line if row is None else int(line[row])

    def error(self, field: str | None, what: str, row: int | None = None) -> DeckError:
        """The error to raise for `field` (in row `row` of a table), or for the entry as a whole."""
        if field is None:
            return DeckError(what, self.file, self.line, self.spelled)
        value = self.values.get(field)
        if row is not None and value is not None:
            value = value[row]
        value = self.references.get((field, row), value)
        return DeckError(what, self.file, self.line_of(field, row), self.spelled, field, value)
