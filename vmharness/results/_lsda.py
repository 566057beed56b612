"""LSDA files, as LS-DYNA writes them for binout: variables in directories, found by tables of symbols.

A file begins with eight bytes: the length of this head, the sizes of lengths, offsets, commands and types, and the
byte order (0: big-endian). Then come records: length, command, content. A table of symbols has a change of directory
for each directory, and a record with name, type, offset and length for each variable; its end has the offset of the
next table.
"""

import posixpath
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from vmharness.results._lines import ResultError

CD, VARIABLE, BEGIN, END, TABLE = 2, 4, 5, 6, 7
TYPES = {1: "i1", 2: "i2", 3: "i4", 4: "i8", 5: "u1", 6: "u2", 7: "u4", 8: "u8", 9: "f4", 10: "f8"}
SIZES = {1: "B", 2: "H", 4: "I", 8: "Q"}


def is_lsda(head: bytes) -> bool:
    """Whether a file begins as LSDA files do."""
    sizes = head[1:5]
    return (
        len(head) >= 8 and 6 <= head[0] <= 16 and all(size in SIZES for size in sizes) and head[5] in (0, 1)
    )


@dataclass(frozen=True)
class Variable:
    """A variable of a file: where its values are."""

    directory: str
    name: str
    type: int
    at: int  # offset of the first value
    count: int


class Lsda:
    """A file whose variables are read one after another, as its tables list them."""

    def __init__(self, file: BinaryIO, name: str) -> None:
        self.file, self.name = file, name
        self.size = file.seek(0, 2)
        file.seek(0)
        head = file.read(8)
        if not is_lsda(head):
            raise ResultError(f"{name}: not an LSDA file: its first bytes are {head.hex()}")
        self.order = ">" if head[5] == 0 else "<"
        self.length, self.offset, self.command, self.type = (SIZES[size] for size in head[1:5])
        self.before = head[1] + head[3] + head[4] + 1  # bytes before the name in a record of data
        self.first = head[0]
        self.cut = ""  # where the file ends too early

    def variables(self) -> Iterator[Variable]:
        """All variables, table by table; ends at the last complete table of a file that is cut off, and says so."""
        self.file.seek(self.first)
        length, command = self._numbers(self.length, self.command)
        if command != TABLE:
            raise ResultError(f"{self.name}: expected the offset of the first table of symbols")
        at = self._numbers(self.offset)[0]
        while at:
            if at + self._size(self.length, self.command) > self.size:
                self.cut = (
                    f"{self.name}: the file ends at byte {self.size}, before its table of symbols at {at}"
                )
                return
            self.file.seek(at)
            length, command = self._numbers(self.length, self.command)
            if command != BEGIN or at + length > self.size:
                self.cut = f"{self.name}: the table of symbols at byte {at} is not complete"
                return
            yield from self._table(self.file.read(length - self._size(self.length, self.command)))
            if 0 < self.next <= at:
                raise ResultError(
                    f"{self.name}: the table of symbols at byte {at} leads back to byte {self.next}"
                )
            at = self.next

    def _table(self, content: bytes) -> Iterator[Variable]:
        """The variables of a table; sets the offset of the next one."""
        place, directory = 0, "/"
        head = self._size(self.length, self.command)
        tail = self._size(self.type, self.offset, self.length)
        while place + head <= len(content):
            length, command = struct.unpack_from(self.order + self.length + self.command, content, place)
            least = head + {VARIABLE: tail, END: self._size(self.offset)}.get(command, 0)
            if not least <= length <= len(content) - place:
                raise ResultError(f"{self.name}: a record of a table of symbols has the length {length}")
            body = content[place + head : place + length]
            place += length
            if command == CD:
                directory = posixpath.normpath(posixpath.join(directory, body.decode("latin-1")))
            elif command == VARIABLE:
                name = body[:-tail].decode("latin-1")
                type_, offset, count = struct.unpack(
                    self.order + self.type + self.offset + self.length, body[-tail:]
                )
                yield Variable(directory, name, type_, offset + self.before + len(name), count)
            elif command == END:
                self.next = int(struct.unpack(self.order + self.offset, body)[0])
                return
        raise ResultError(f"{self.name}: a table of symbols has no end")

    def read(self, variable: Variable, first: int = 0, count: int | None = None) -> NDArray[np.generic]:
        """Values of a variable (count,); raises ResultError where the file does not have them."""
        kind = TYPES.get(variable.type)
        if kind is None:
            raise ResultError(
                f"{self.name}: {variable.directory}/{variable.name} is of the unknown type {variable.type}"
            )
        count = variable.count - first if count is None else count
        size = int(kind[1])
        begin, end = variable.at + first * size, variable.at + (first + count) * size
        if first + count > variable.count or end > self.size:
            raise ResultError(f"{self.name}: the file ends within {variable.directory}/{variable.name}")
        self.file.seek(begin)
        return np.frombuffer(self.file.read(end - begin), self.order + kind)

    def text(self, variable: Variable) -> str:
        """The text of a variable."""
        return self.read(variable).tobytes().decode("latin-1").strip("\0 ")

    def _numbers(self, *kinds: str) -> tuple[int, ...]:
        form = self.order + "".join(kinds)
        content = self.file.read(struct.calcsize(form))
        if len(content) < struct.calcsize(form):
            raise ResultError(f"{self.name}: the file ends at byte {self.size}, within its head")
        return struct.unpack(form, content)

    def _size(self, *kinds: str) -> int:
        return struct.calcsize(self.order + "".join(kinds))
