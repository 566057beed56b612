"""A card: one line of input, as named fields in the order of their columns."""

import re
from collections.abc import Callable, Mapping
from typing import Any

from vmharness.deck.field import LONG_WIDTH, Field, Value

COLUMNS = 80  # of a line in standard format; what stands beyond is no data
TAB = "a tab in a data line hides its columns; write blanks or commas"
NOTHING = re.compile(r"[ 0.]*")  # blanks and zeros


class Card:
    """Fields of one line, in column order: those of a mapping, then those named.

    `when` (a function of the entry as read so far) says whether the card is there; an `optional` card is
    there if lines remain. The fields of a card that is not there have their defaults. Names that begin with
    an underscore are unused columns and are not kept.
    """

    def __init__(
        self,
        first: Mapping[str, Field] | None = None,
        /,
        *,
        when: Callable[[Any], bool] | None = None,
        optional: bool = False,
        **fields: Field,
    ) -> None:
        self.fields = {**(first or {}), **fields}
        self.when = when
        self.optional = optional

    def defaults(self) -> dict[str, Value | None]:
        """What each field has where the card is not there."""
        return {name: field.default for name, field in self.fields.items() if name[0] != "_"}

    def items(self, line: str, long: bool) -> list[str]:
        """Characters of each field of `line`; raises ValueError where text is left over.

        A comma makes the line comma-separated, but a comma within a heading is a part of it. What stands beyond column
        80 (160 in long format) is no data, as in LS-DYNA, and zeros beyond the last field are none. A heading may be
        too long, and may have tabs.
        """
        widths = [field.columns(long) for field in self.fields.values()]
        heading = list(self.fields.values())[-1].is_heading
        end = sum(widths[:-1]) if heading else max(line_end(long), sum(widths))
        if "," in line[:end]:
            return self._separated(line if heading or line[end - 1 : end].strip() else line[:end], heading)
        if "\t" in line[:end]:
            raise ValueError(TAB)
        if not heading and not NOTHING.fullmatch(line, sum(widths), end):
            raise ValueError(f"text beyond the last field, which ends in column {sum(widths)}")
        ends = [sum(widths[: i + 1]) for i in range(len(widths))]
        return [line[end - width : end] for width, end in zip(widths, ends, strict=True)]

    def _separated(self, line: str, heading: bool) -> list[str]:
        count = len(self.fields)
        items = line.split(",", count - 1 if heading else -1)
        if not all(NOTHING.fullmatch(item) for item in items[count:]):
            raise ValueError(f"more than the {count} items of this card")
        items = items[:count]
        return items + [""] * (count - len(items))


def line_end(long: bool) -> int:
    """The columns of a line that are data."""
    return 8 * LONG_WIDTH if long else COLUMNS


class Rows(Card):
    """Lines of the same fields until the block ends: one array a field, one value a line.

    With `per_line` = 8 the only field stands 8 times a line, as in lists of ids: one flat array, without the
    blanks and zeros. With `together` = 2 it comes in pairs, and what is left out are pairs of zeros alone.
    """

    def __init__(
        self,
        first: Mapping[str, Field] | None = None,
        /,
        *,
        per_line: int = 1,
        together: int = 1,
        **fields: Field,
    ) -> None:
        self.flat = next(iter(fields)) if per_line > 1 else ""
        self.together = together
        if self.flat:
            fields = {f"{self.flat}{i + 1}": fields[self.flat] for i in range(per_line)}
        super().__init__({**(first or {}), **fields})
