"""rbdout: motion of rigid bodies: coordinates, displacements, velocities and accelerations in lines of `%12.4E`.

Rotations stand behind translations. The lines that follow in the axes of the body are passed over.
"""

import re
from collections.abc import Mapping
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "rbdout", "*DATABASE_RBDOUT"
DIGITS = 5.0
SCHEME = "positions and velocities at t_n"

STATE = re.compile(r"\s*r i g i d   b o d y   m o t i o n   a t\s+cycle=\s*\d+\s+time=\s*(\S+)")
BODY = re.compile(r" (?:nodal )?rigid body\s*(\d+)")
ROW = re.compile(r"\s*(coordinates|displacements|velocities|accelerations):(.*)")
QUANTITIES: Mapping[str, tuple[str, ...]] = {
    "coordinates": ("coordinate",),
    "displacements": ("displacement", "rotation"),
    "velocities": ("velocity", "angular-velocity"),
    "accelerations": ("acceleration", "angular-acceleration"),
}
NAMES = {
    row: tuple(f"{axis}-{name}" for name in names for axis in "xyz") for row, names in QUANTITIES.items()
}

VARIABLES = {
    f"{axis}-{name}": f"global_{variable}{axis}"
    for axis in "xyz"
    for name, variable in (
        ("coordinate", ""), ("displacement", "d"), ("rotation", "rd"), ("velocity", "v"), ("angular-velocity", "rv"),
        ("acceleration", "a"), ("angular-acceleration", "ra"),
    )
}  # fmt: skip


def recognises(name: str, head: bytes) -> bool:
    """By the heading of a state, or by the name."""
    return b"r i g i d   b o d y   m o t i o n" in head or (name.startswith("rbdout") and b"\0" not in head)


def gives(key: Key) -> bool:
    """The motion of rigid bodies."""
    return key.kind == "rigid" and key.component in VARIABLES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted rows of all states."""
    lines, recorder = Lines(path), Recorder(path.name, keys)
    wanted, number, in_space = {key.number for key in keys}, 0, False
    for line in lines:
        if found := STATE.match(line):
            recorder.begin(found.group(1), lines)
        elif found := BODY.match(line):
            number, in_space = int(found.group(1)), True
        elif line.startswith(("principal", " output in principal")):
            in_space = False
        elif in_space and number in wanted and (found := ROW.match(line)):
            names = NAMES[found.group(1)]
            for name, value in zip(names, lines.numbers(found.group(2), names), strict=True):
                recorder.put(Key("rigid", name, number), value)
    return recorded(recorder, lines, "states headed r i g i d   b o d y   m o t i o n")
