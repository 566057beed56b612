"""Blocks of a page for all formats: drawings, tables of text, sections."""

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Figure:
    """A drawing: the name of its file without suffix, its caption, its <svg> element."""

    name: str
    caption: str
    svg: str


@dataclass(frozen=True)
class Table:
    """Rows of text under a head; the columns from `numbers` on hold numbers, except the last `words` columns."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: int = 1
    words: int = 0

    def is_number(self, column: int) -> bool:
        """Whether a column holds numbers."""
        return self.numbers <= column < len(self.head) - self.words


@dataclass(frozen=True)
class Section:
    """A section of the page: paragraphs, then tables, then figures, then remarks, then long lists."""

    title: str
    summary: str  # a few words for the index, such as "order 2.00"
    text: Sequence[str] = ()
    tables: Sequence[Table] = ()
    figures: Sequence[Figure] = ()
    remarks: Sequence[str] = ()
    folded: Sequence[tuple[str, str]] = ()  # a line, and the text that opens below it
    made: str = ""  # the solver and sources of its record, as a sentence
