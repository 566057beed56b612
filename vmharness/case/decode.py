"""Decoding of case.toml into its tables; errors name their place in the file."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec

from vmharness.case.error import CaseError, near
from vmharness.case.format import CaseFile

FILE = "case.toml"


def decode(path: Path) -> CaseFile:
    """The tables of the file at `path`; raises CaseError if it is missing, is not TOML or does not fit the format."""
    try:
        return msgspec.toml.decode(path.read_bytes(), type=CaseFile)
    except OSError as error:
        raise CaseError(f"{path.parent.name}: no {FILE} can be read: {error.strerror}") from None
    except msgspec.ValidationError as error:
        raise CaseError(f"{path.parent.name}/{FILE}: {_place(str(error))}") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise CaseError(f"{path.parent.name}/{FILE}: not TOML: {error}") from None


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
