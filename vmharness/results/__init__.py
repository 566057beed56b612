"""Result files of other solvers, read into channels: one module of this folder for each format.

Contract of a module:

    NAME                    its name, for messages: nodout
    DATABASE                what a deck must ask for to get such a file: *DATABASE_NODOUT; empty if nothing of its own
    DIGITS                  significant decimal digits of a value; None where each file has its own
    SCHEME                  at which instants the values of a cycle hold, in words
    recognises(name, head)  whether a file is of this format, by its name and its first bytes
    gives(key)              whether the format can hold a quantity
    read(path, keys)        the wanted quantities over time, as a list of Series; raises ResultError

A quantity is a `Key`. `_quantity.py` says of which quantities a channel of a case is made, for all formats alike.
Files are read in one pass, and only what is wanted is kept: memory does not grow with the size of a file.
"""

from pathlib import Path
from typing import Protocol, cast

from vmharness import plugins
from vmharness.results._key import Key, Sum
from vmharness.results._lines import ResultError
from vmharness.results._quantity import Quantities, quantities
from vmharness.results._series import Series, join

__all__ = [
    "Format",
    "Key",
    "Quantities",
    "ResultError",
    "Series",
    "Sum",
    "formats",
    "join",
    "quantities",
    "recognise",
]

REQUIRED = ("NAME", "DATABASE", "DIGITS", "SCHEME", "recognises", "gives", "read")
HEAD = 1 << 16  # bytes by which a file is recognised


class Format(Protocol):
    """A module that reads a format."""

    NAME: str
    DATABASE: str
    DIGITS: float | None
    SCHEME: str

    def recognises(self, name: str, head: bytes) -> bool:
        """Whether a file is of this format."""

    def gives(self, key: Key) -> bool:
        """Whether the format can hold the quantity."""

    def read(self, path: Path, keys: set[Key]) -> list[Series]:
        """Those of the quantities that the file holds; raises ResultError where it is damaged."""


def formats() -> list[Format]:
    """All formats, by name."""
    return [cast(Format, module) for module in plugins.modules(__name__, *REQUIRED)]


def recognise(path: Path) -> Format | None:
    """The format of a file, or None; raises OSError."""
    with path.open("rb") as file:
        head = file.read(HEAD)
    return next((each for each in formats() if each.recognises(path.name.lower(), head)), None)
