"""The files of a deck as one stream of blocks: *INCLUDE followed, and guarded."""

import hashlib
import os
import re
from collections.abc import Iterator
from pathlib import Path

from vmharness.deck.block import BEGINNINGS, Block, blocks
from vmharness.deck.card import COLUMNS
from vmharness.deck.error import DeckError

INCLUDES = ("INCLUDE", "INCLUDE_PATH", "INCLUDE_PATH_RELATIVE")
DEEPEST = 20  # includes within includes
BEGIN = "a deck begins with *KEYWORD; only comments may come before"
MOST_BYTES = 2**29  # of all files together

LONE_CR = re.compile(rb"\r(?![\r\n]|\Z)")


class Source:
    """Reads a deck's files; `files` maps the name of each, relative to the deck's folder, to its SHA-256.

    `text` stands in place of the file at `path`, if given. What is ill-formed is added to `wrong`.
    """

    def __init__(self, path: Path, include_outside: bool, wrong: list[DeckError], text: str = "") -> None:
        self.wrong = wrong
        self.text = text
        self.path = path
        self.folder = path.parent.resolve()
        self.searched = [self.folder]  # for includes: the deck's folder, and those of *INCLUDE_PATH
        self.include_outside = include_outside
        self.files: dict[str, str] = {}
        self.bytes = 0

    def blocks(self) -> Iterator[Block]:
        """The blocks of the deck in the order in which they take effect, those of includes in their place.

        Raises DeckError where there is no deck; what is wrong with an include is added to `wrong`.
        """
        name = self.path.name
        if not self.text and not self.path.is_file():
            raise DeckError("no such file", name)
        yield from self._file(self.folder / name, (), False, DeckError("", name))

    def _file(self, path: Path, chain: tuple[str, ...], long: bool, place: DeckError) -> Iterator[Block]:
        """The blocks of one file; `chain` are the files that led to it, `place` the line that asks for it."""
        name = self._name(path)
        if name in chain:
            raise _at(place, f"a file includes itself: {' -> '.join((*chain, name))}")
        if name in self.files:
            raise _at(place, "the file is included already")
        if len(chain) > DEEPEST:
            raise _at(place, f"includes are nested more than {DEEPEST} deep")
        text = self._text(path, name, place)
        found = list(blocks(text, name, long, self.wrong))
        if not chain and (not found or found[0].name not in BEGINNINGS):
            raise DeckError(BEGIN, name, found[0].line if found else 1, found[0].name if found else "")
        for i, block in enumerate(found):
            if block.name in BEGINNINGS:
                self._check_beginning(block, first=i == 0)
                long = block.long
            if block.name in INCLUDES:
                yield from self._include(block, (*chain, name), long)
            else:
                yield block

    def _check_beginning(self, block: Block, first: bool) -> None:
        if not first:
            self.wrong.append(block.error(f"*{block.name} may stand only once, at the beginning of a file"))
        elif block.name == "KEYWORD" and any(line.strip() for line in block.lines):
            self.wrong.append(block.error("*KEYWORD has no data lines", block.numbers[0]))

    def _include(self, block: Block, chain: tuple[str, ...], long: bool) -> Iterator[Block]:
        """The blocks of the files that an *INCLUDE names; an *INCLUDE_PATH adds folders where they may lie."""
        for wanted, line in names(block, self.wrong):
            asking = DeckError("", block.file, line, block.name, "filename", wanted)
            try:
                if block.name == "INCLUDE":
                    yield from self._file(self._target(wanted, asking), chain, long, asking)
                else:
                    self.searched.append(self._allowed(self.folder / wanted, asking))
            except DeckError as error:
                self.wrong.append(error)

    def _target(self, wanted: str, place: DeckError) -> Path:
        """The file that an include names, in the first of the searched folders that has it."""
        for folder in self.searched:
            target = self._allowed(folder / wanted, place)
            if target.is_file():
                return target
        raise _at(place, "no such file in the deck's folder")

    def _allowed(self, path: Path, place: DeckError) -> Path:
        """The path with its links followed; raises DeckError unless it lies where files may be read."""
        try:
            target = path.resolve()
            target.is_file()
        except (OSError, ValueError, RuntimeError):
            raise _at(place, "not a file name") from None
        if not (self.include_outside or target.is_relative_to(self.folder)):
            raise _at(place, "lies outside the deck's folder, where files are read only if allowed")
        return target

    def _text(self, path: Path, name: str, place: DeckError) -> str:
        if self.text and path == self.folder / self.path.name:
            self.files[name] = hashlib.sha256(self.text.encode()).hexdigest()
            return self.text
        try:
            self.bytes += path.stat().st_size
            if self.bytes > MOST_BYTES:
                raise _at(place, f"the deck has more than {MOST_BYTES} bytes")
            content = path.read_bytes()
        except OSError as error:
            raise _at(place, f"cannot be read: {error.strerror}") from None
        self.files[name] = hashlib.sha256(content).hexdigest()
        return decoded(content, name)

    def _name(self, path: Path) -> str:
        try:
            return Path(os.path.relpath(path, self.folder)).as_posix()
        except ValueError:  # another drive
            return str(path)


def decoded(content: bytes, name: str) -> str:
    """The text of a file; raises DeckError where it has no lines as LS-DYNA reads them.

    A file that is not UTF-8 is read byte by byte: comments and titles may have any encoding of single bytes.
    """
    if content.startswith((b"\xff\xfe", b"\xfe\xff")) or content.count(0) > len(content) // 3:
        raise DeckError("is written in UTF-16 or UTF-32; save it as ASCII or UTF-8", name, 1)
    if found := LONE_CR.search(content):
        line = 1 + content.count(b"\n", 0, found.start())
        raise DeckError("a line ends in CR alone; convert line ends to LF or CR LF", name, line)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def names(block: Block, wrong: list[DeckError]) -> Iterator[tuple[str, int]]:
    """The file names of an *INCLUDE, each with its line; " +" at the end of a line continues the name.

    What stands beyond column 80 after a blank is no part of a name.
    """
    wanted = ""
    for line, number in zip(block.lines, block.numbers, strict=True):
        part = (line if line[COLUMNS - 1 : COLUMNS].strip() else line[:COLUMNS]).strip()
        if part.endswith(" +"):
            wanted += part[:-2].rstrip()
        elif wanted + part:
            yield wanted + part, number
            wanted = ""
    if wanted:
        wrong.append(block.error("the continued file name does not end", block.numbers[-1]))
    if not any(line.strip() for line in block.lines):
        wrong.append(block.error("a file name is required"))


def _at(place: DeckError, what: str) -> DeckError:
    return DeckError(what, place.file, place.line, place.keyword, place.field, place.value)
