"""sleout: energies of contacts. A head with the time and the names of columns, then `%10d%13.4E%13.4E` a contact."""

import re
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "sleout", "*DATABASE_SLEOUT"
DIGITS = 5.0
SCHEME = "energies at t_n; those of both sides are added"

TIME = re.compile(r"\s*contact interface energy file, time=\s*(\S+)")
SIDES = ("slave", "master", "surfa", "surfb")


def recognises(name: str, head: bytes) -> bool:
    """By its first lines, or by the name."""
    return b" contact interface energy file" in head or (name.startswith("sleout") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Energies of contacts."""
    return key.kind == "contact" and key.component == "energy"


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted energies of all states."""
    lines, recorder = Lines(path), Recorder(path.name, keys)
    names: tuple[str, ...] = ()
    for line in lines:
        words = line.split()
        if found := TIME.match(line):
            recorder.begin(found.group(1), lines)
        elif words[:1] == ["#"]:
            names = tuple(word.lower() for word in line.partition("cycle")[0].split()[1:])
        elif words[:1] == ["summary"]:
            names = ()
        elif names and words:
            key = Key("contact", "energy", lines.integer(words[0], "the number of a contact"))
            rest = line.strip().partition(" ")[2]
            given = names[: max(len(rest.split()), 1)]  # a single surface has one side
            for name, value in zip(given, lines.numbers(rest, given), strict=True):
                if name in SIDES:
                    recorder.add(key, value)
    return recorded(recorder, lines, "` contact interface energy file, time=`")
