"""Check of case.toml: all its numbers are finite, since no comparison with NaN holds and infinity bounds nothing."""

import math
from collections.abc import Iterator
from typing import Any

from msgspec import Struct
from msgspec.structs import asdict

from vmharness.case.check import Checks


def check_numbers(checks: Checks) -> None:
    """Raise CaseError, with its place, for the first number that is infinite or NaN."""
    for (table, *keys), value in _numbers(checks.file):
        if not math.isfinite(value):
            entry = " ".join([f"[{table}]", *keys[:1]])
            raise checks.wrong(": ".join([entry, *keys[1:]]), f"{value} is not a finite number")


def _numbers(table: Any, place: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], float]]:
    """All real numbers of a table, each with the keys that lead to it; items of a list are counted from 1."""
    if isinstance(table, float):
        yield place, table
    elif isinstance(table, Struct):
        yield from _numbers(asdict(table), place)
    elif isinstance(table, dict):
        for key, value in table.items():
            yield from _numbers(value, (*place, key))
    elif isinstance(table, list | tuple):
        for number, value in enumerate(table, 1):
            yield from _numbers(value, (*place, str(number)))
