"""Decoding of case.toml into its tables; errors name their place in the file."""

import re
from collections.abc import Iterator
from pathlib import Path
from traceback import walk_tb
from typing import Any

import msgspec

from vmharness import toml
from vmharness.case.error import CaseError, near
from vmharness.case.format import CaseFile

FILE = "case.toml"
DIGITS = 4300  # of a whole number that Python reads
LONG = re.compile(rf"\d{{{DIGITS + 1}}}")


def decode(path: Path) -> CaseFile:
    """The tables of the file at `path`; raises CaseError if it is missing, is not TOML or does not fit the format."""
    place = f"{path.parent.name}/{FILE}"
    try:
        text = toml.text_of(path)
    except OSError as error:
        raise CaseError(f"{path.parent.name}: no {FILE} can be read: {error.strerror}") from None
    except toml.TomlError as error:
        raise CaseError(f"{place}:{error}") from None
    try:
        return msgspec.toml.decode(text, type=CaseFile)
    except msgspec.ValidationError as error:
        raise CaseError(f"{place}: {_place(str(error))}") from None
    except msgspec.DecodeError as error:
        raise CaseError(f"{place}: not TOML: {error}") from None
    except RecursionError as error:
        raise CaseError(f"{place}:{_line(error)}: nested too deeply to be read") from None
    except ValueError as error:
        if not LONG.search(text):
            raise CaseError(f"{place}:{_line(error)}: {error}") from None
        raise CaseError(f"{place}:{_line(error)}: a whole number of more than {DIGITS} digits") from None


def utf8(content: bytes, place: str) -> str:
    """The text of a file; raises CaseError with the line that is not UTF-8."""
    try:
        return toml.utf8(content)
    except toml.TomlError as error:
        raise CaseError(f"{place}:{error}") from None


def _line(error: Exception) -> int:
    """The line that tomllib was at: its functions have the text `src` and the place `pos` in it."""
    found = 1
    for frame, _ in walk_tb(error.__traceback__):
        source, at = frame.f_locals.get("src"), frame.f_locals.get("pos")
        if isinstance(source, str) and isinstance(at, int):
            found = source.count("\n", 0, at) + 1
    return found


def _place(message: str) -> str:
    """Say `Object contains unknown field `x` - at `$.results[2]`` as `[results] 3: unknown key x`."""
    what, _, where = message.partition(" - at `$.")
    where = where.rstrip("`")
    place = re.sub(r"\[(\d+)\]", lambda index: f" {int(index[1]) + 1}", where)
    table, *rest = re.split(r"[. ]", place, maxsplit=1)
    prefix = f"[{table}] {rest[0]}: " if rest else f"[{table}]: " if table else ""
    if unknown := re.match(r"Object contains unknown field `(.+)`", what):
        what = f"unknown key {unknown[1]}{near(unknown[1], _keys(where))}"
    elif missing := re.match(r"Object missing required field `(.+)`", what):
        what = f"{missing[1]} is missing"
    return prefix + what


def _keys(where: str) -> list[str]:
    """The keys of the table that a path such as `results[2].tolerance` leads to."""
    table: type[msgspec.Struct] = CaseFile
    for step in [name for name in re.split(r"\.|\[.*?\]", where) if name]:
        types = {field.name: field.type for field in msgspec.structs.fields(table)}
        table = next((part for part in _parts(types.get(step)) if _is_table(part)), table)
    return [field.name for field in msgspec.structs.fields(table)]


def _is_table(part: Any) -> bool:
    return isinstance(part, type) and issubclass(part, msgspec.Struct)


def _parts(annotation: Any) -> Iterator[Any]:
    """A type and all types inside it."""
    yield annotation
    for part in getattr(annotation, "__args__", ()):
        yield from _parts(part)
