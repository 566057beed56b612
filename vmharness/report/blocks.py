"""Blocks of a page, whatever its format: drawings, tables of text, sections."""

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Figure:
    """A drawing: the stem of its file, its caption, its <svg> element."""

    name: str
    caption: str
    svg: str


@dataclass(frozen=True)
class Table:
    """Rows of text under a head; columns from `numbers` on are numbers, but for the last `words`."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: int = 1
    words: int = 0

    def is_number(self, column: int) -> bool:
        """Whether a column is of numbers."""
        return self.numbers <= column < len(self.head) - self.words


@dataclass(frozen=True)
class Section:
    """A section of the page: paragraphs, then tables, then figures, then remarks."""

    title: str
    summary: str  # a few words for the index, such as "order 2.00"
    text: Sequence[str] = ()
    tables: Sequence[Table] = ()
    figures: Sequence[Figure] = ()
    remarks: Sequence[str] = ()
    made: str = ""  # what made the record that all this is from
