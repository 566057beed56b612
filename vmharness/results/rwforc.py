"""rwforc: forces of rigid walls. A row for each wall and instant: `%12.5E%8d%15.6E%15.6E%15.6E%15.6E`.

Rows of segments, which begin with blanks, may follow. The normal force is positive if nodes press on the wall.
"""

from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "rwforc", "*DATABASE_RWFORC"
DIGITS = 7.0
SCHEME = "the force of the step that ends at t_n"

HEAD = ("time", "wall#", "normal-force")

VARIABLES = {"normal-force": "normal_force"}


def recognises(name: str, head: bytes) -> bool:
    """By the line of names, or by the name."""
    return b" wall#   normal-force" in head or (name.startswith("rwforc") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Normal forces of walls."""
    return key.kind == "wall" and key.component in VARIABLES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted forces of all states."""
    lines, recorder, at = Lines(path), Recorder(path.name, keys), ""
    names: tuple[str, ...] = ()
    for line in lines:
        words = line.split()
        if tuple(words[:3]) == HEAD:
            names = tuple(words)
        elif not words or (line[:2].strip().isalpha() and words[0].lower() not in ("nan", "total", "inf")):
            names = ()  # the head of a later run
        elif names and line[:12].strip() and words[0] != "total":
            values = lines.numbers(line, names)
            key = Key("wall", HEAD[2], int(values[1]))
            if words[0] != at or recorder.has(key):
                at = words[0]
                recorder.begin(at, lines)
            recorder.put(key, values[2])
    return recorded(recorder, lines, "a line of names, `time  wall#  normal-force ...`, and rows of numbers")
