"""A field of a card: kind, width, default, and what would be ill-formed.

What a solver can do with a well-formed value is not said here, but by the solver: see support.py.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Literal

from vmharness.deck.number import to_integer, to_real

Value = int | float | str

REFERENCE = re.compile(r"-?&\s*[A-Za-z_]\w*")

LONG_WIDTH = 20  # columns of a field in long format
HEADING = 70  # a text at least this wide is a heading: commas belong to it, and long format keeps its width


@dataclass(frozen=True, slots=True, kw_only=True)
class Field:
    """One field of a card; `default` None means that a value is required."""

    kind: Literal["integer", "real", "text"]
    width: int
    default: Value | None
    zero_is_default: bool = False
    above: float | None = None  # of an id, which must be positive
    unused: bool = False  # a column without meaning
    capitals: bool = False  # a word in any case, kept in capitals

    @property
    def is_heading(self) -> bool:
        return self.kind == "text" and self.width >= HEADING

    def columns(self, long: bool) -> int:
        """Width in columns; in long format the same for all but headings."""
        return LONG_WIDTH if long and not self.is_heading else self.width

    def read(self, item: str, parameters: Mapping[str, Value]) -> Value:
        """The value that the characters `item` of a card give; raises ValueError saying what is wrong."""
        item = item.strip()
        if REFERENCE.fullmatch(item):
            value = self._convert(substitute(item, parameters))
        elif item:
            value = self._convert(item)
        elif self.default is None:
            raise ValueError("a value is required")
        else:
            value = self.default
        if self.zero_is_default and value == 0 and self.default is not None:
            value = self.default
        if fault := self.fault(value):
            raise ValueError(fault)
        return value

    def fault(self, value: Value) -> str:
        """What is wrong with `value`, or nothing."""
        if isinstance(value, str):
            return ""
        if self.unused and value != 0:
            return f"only {self.default} is supported"
        if self.above is not None and not value > self.above:
            return f"must be greater than {self.above:g}"
        return ""

    @property
    def stand_in(self) -> Value:
        """A value to go on with where the one of the deck is ill-formed."""
        return self.default if self.default is not None else "" if self.kind == "text" else 0

    def _convert(self, item: str) -> Value:
        if self.kind == "integer":
            return to_integer(item)
        if self.kind == "real":
            return to_real(item)
        return item.upper() if self.capitals else item


def substitute(item: str, parameters: Mapping[str, Value]) -> str:
    """The value of `&name` or `-&name`, written so that reading it gives the same number."""
    sign, _, name = item.partition("&")
    name = name.strip().lower()
    if name not in parameters:
        near = get_close_matches(name, parameters, n=1)
        raise ValueError("undefined parameter" + (f"; did you mean &{near[0]}?" if near else ""))
    value = parameters[name]
    if not sign:
        return str(value)
    if isinstance(value, str):
        raise ValueError("a text parameter has no sign")
    return str(-value)


def shown(item: str, parameters: Mapping[str, Value]) -> str:
    """The characters of a field for a message, a parameter with its value.

    >>> shown(" &rho", {"rho": -1.0}), shown(" 2.0 ", {})
    ('&rho (-1.0)', '2.0')
    """
    item = item.strip()
    try:
        return f"{item} ({substitute(item, parameters)})" if REFERENCE.fullmatch(item) else item
    except ValueError:
        return item


def integer(
    default: int | None = None,
    *,
    width: int = 10,
    zero_is_default: bool = False,
    above: float | None = None,
) -> Field:
    """An integer; without a default it is required."""
    return Field(kind="integer", width=width, default=default, zero_is_default=zero_is_default, above=above)


def real(
    default: float | None = None,
    *,
    width: int = 10,
    zero_is_default: bool = False,
    above: float | None = None,
) -> Field:
    """A real number; without a default it is required."""
    return Field(kind="real", width=width, default=default, zero_is_default=zero_is_default, above=above)


def text(default: str | None = None, *, width: int = 10, capitals: bool = False) -> Field:
    """A text without the blanks around it; a word in `capitals` may be written in any case."""
    return Field(kind="text", width=width, default=default, capitals=capitals)


def skip(width: int = 10) -> Field:
    """A column without meaning: blank or zero; anything else is refused, for it may have been meant."""
    return Field(kind="real", width=width, default=0.0, unused=True)
