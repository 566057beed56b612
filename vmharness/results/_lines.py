"""Text of result files: complete lines, and numbers as Fortran and C write them."""

import re
from collections.abc import Iterator
from math import isfinite
from pathlib import Path

# The letter of an exponent may be missing if it has three digits; numbers may touch each other.
NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+))(?:[eEdD]([+-]?\d{1,3})|([+-]\d{3}))?")
LOOKED = 20
SOLVER = re.compile(r"ls-dyna\s+(.*?)\s+date\b", re.IGNORECASE)
DOTTED = re.compile(r" (\S.*?)\s*\.{2,}\s*(\S+)(?:\s+wall#\s*\d+)?\s*$")  # ` kinetic energy......   1.0E+00`


class ResultError(Exception):
    """A result file cannot be read; `str` is "file:line: what is wrong"."""


class Lines:
    """The lines of a file, one by one, with the number of the current one.

    A last line without an end is cut off: it is left out, and `cut` says so.
    """

    def __init__(self, path: Path) -> None:
        self.path, self.number, self.cut, self.solver = path, 0, False, ""
        self.digits, self.looked = 0, 0  # significant digits of numbers, in those that were looked at

    def __iter__(self) -> Iterator[str]:
        with self.path.open(encoding="latin-1", newline="\n") as file:
            for self.number, line in enumerate(file, 1):
                if line[-1] != "\n":
                    self.cut = True
                    return
                if self.number < 5 and (found := SOLVER.search(line)):
                    self.solver = f"LS-DYNA {found.group(1).strip('()')}"
                yield line

    @property
    def place(self) -> str:
        """The file and the current line."""
        return f"{self.path.name}:{self.number}"

    def error(self, what: str) -> ResultError:
        """The error to raise about the current line."""
        return ResultError(f"{self.place}: {what}")

    def time_of(self, text: str) -> float:
        """The time that `text` writes; raises ResultError."""
        return self._read(text, ("the time",))[0]

    def integer(self, text: str, what: str) -> int:
        """The integer that `text` writes; raises ResultError that says of `what`."""
        if not text.isdigit():
            raise self.error(f"{what} is {text}: expected an integer")
        return int(text)

    def number_of(self, text: str, what: str) -> float:
        """The one number that `text` writes; raises ResultError that says of `what`."""
        return self.numbers(text, (what,))[0]

    def numbers(self, text: str, names: "tuple[str, ...]") -> list[float]:
        """The numbers that `text` writes, one for each of `names`; raises ResultError."""
        if self.looked < LOOKED:  # all numbers of a file have the same format
            self.looked += 1
            self.digits = max(self.digits, *map(significant, text.split()), 0)
        return self._read(text, names)

    def _read(self, text: str, names: "tuple[str, ...]") -> list[float]:
        try:
            values = [float(word) for word in text.split()]
        except ValueError:
            values = list(self._scan(text, names))
        if len(values) != len(names) or "_" in text:
            found = f"{len(values)} numbers" if len(values) != 1 else "one number"
            raise self.error(f"{found} in place of {len(names)}: {', '.join(names)}")
        for name, value in zip(names, values, strict=True):
            if not isfinite(value):
                raise self.error(f"{name} is {value}: the run has diverged, or the file is damaged")
        return values

    def _scan(self, text: str, names: "tuple[str, ...]") -> Iterator[float]:
        """Numbers one after another, whether or not there is a blank between them.

        >>> list(Lines(Path("nodout"))._scan("-5.49632E-09-3.67355E-10 6.319000-103", ()))
        [-5.49632e-09, -3.67355e-10, 6.319e-103]
        """
        end, count, text = 0, 0, text.rstrip()
        while end < len(text):
            found = NUMBER.match(text, end)
            if found is None:
                word = text[end:].split()[0]
                name = f"{names[count]} is {word}" if count < len(names) else f"{word} is left over"
                why = "the number did not fit its field" if set(word) == {"*"} else "expected a number"
                raise self.error(f"{name}: {why}")
            mantissa, lettered, bare = found.groups()
            yield float(f"{mantissa}e{lettered or bare or 0}")
            end, count = found.end(), count + 1


def significant(text: str) -> int:
    """The number of decimal digits of the mantissa that `text` writes.

    >>> significant("-1.2345E-02"), significant("0.0000000E+00"), significant("00120")
    (5, 8, 5)
    """
    found = NUMBER.match(text)
    return sum(each.isdigit() for each in found.group(1)) if found else 0
