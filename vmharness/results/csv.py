"""CSV: a line of names, then a line for each instant.

A column has the name of a channel of the case; that of the instants is `time` or `t`.
Comma, semicolon or tab separates the columns; a line that begins with # is a comment.
"""

from dataclasses import replace
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines, ResultError
from vmharness.results._series import Recorder, Series

NAME, DATABASE = "CSV", ""
DIGITS = None  # as many as the file writes
SCHEME = "as the columns say; all at the same instants"

TIMES = ("time", "t")


def recognises(name: str, head: bytes) -> bool:
    """By the name."""
    return name.endswith((".csv", ".tsv")) and b"\0" not in head


def gives(key: Key) -> bool:
    """Any column."""
    return key.kind == "column"


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted columns; raises ResultError if none of them is the time."""
    lines = Lines(path)
    rows = (line for line in lines if line.strip() and not line.startswith("#"))
    head = next(rows, "")
    mark = next((mark for mark in (",", ";", "\t") if mark in head), ",")
    names = [name.strip().strip('"').strip() for name in head.split(mark)]
    if twice := {name for name in names if names.count(name) > 1}:
        raise lines.error(f"two columns are called {min(twice)}")
    at = next((place for place, name in enumerate(names) if name.lower() in TIMES), None)
    if at is None:
        raise ResultError(
            f"{path.name}:1: no column time; there are: {', '.join(filter(None, names)) or 'none'}"
        )
    wanted = {place: Key("column", name) for place, name in enumerate(names) if Key("column", name) in keys}
    recorder = Recorder(path.name, keys)
    for line in rows:
        cells = line.strip("\r\n").split(mark)
        if len(cells) != len(names):
            raise lines.error(f"{len(cells)} columns in place of {len(names)}")
        recorder.state(lines.time_of(cells[at]), lines.place)
        for place, key in wanted.items():
            recorder.put(key, lines.number_of(cells[place], names[place]))
    found = recorder.series(lines.place, False, "", "lines of numbers under the line of names")
    notes = found.notes
    if lines.cut:
        notes += (f"{path.name}:{lines.number}: the last line has no end, and is left out",)
    offered = tuple(name for name in names if name)
    return [replace(found, digits=float(min(lines.digits, 17)), notes=notes, offered=offered)]
