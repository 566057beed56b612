"""nodout: motion of the nodes of *DATABASE_HISTORY_NODE, in a block for each state; rotations in a second block.

A block begins with ` n o d a l   p r i n t   o u t   f o r   t i m e  s t e p%8d   ( at time%14.7E )` and a line of
names; then there is a row for each node, `%9d%13.4E` and more numbers as `%12.4E`.
"""

import re
from collections.abc import Mapping
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "nodout", "*DATABASE_NODOUT, and the node in *DATABASE_HISTORY_NODE"
DIGITS = 5.0
SCHEME = "displacements, velocities and accelerations at t_n"

HEADING = re.compile(rb"n o d a l   p r i n t   o u t")
TIME = re.compile(r"s t e p\s*(\d+)\s*\( at time\s*(\S+?)\s*\)")
QUANTITIES: Mapping[str, str] = {
    "disp": "displacement", "vel": "velocity", "accl": "acceleration", "coor": "coordinate",
    "rot": "rotation", "rot vel": "angular-velocity", "rot acc": "angular-acceleration",
}  # fmt: skip
COLUMN = re.compile(r"([xyz])-(rot vel|rot acc|\w+)")

VARIABLES = {
    f"{axis}-{quantity}": f"{prefix}{axis}_{name}"
    for axis in "xyz"
    for quantity, prefix, name in (
        ("displacement", "", "displacement"), ("velocity", "", "velocity"), ("acceleration", "", "acceleration"),
        ("coordinate", "", "coordinate"), ("rotation", "r", "displacement"), ("angular-velocity", "r", "velocity"),
        ("angular-acceleration", "r", "acceleration"),
    )
}  # fmt: skip


def recognises(name: str, head: bytes) -> bool:
    """By the heading of a state, or by the name."""
    return HEADING.search(head) is not None or (name.startswith("nodout") and b"\0" not in head)


def gives(key: Key) -> bool:
    """The motion of nodes."""
    return key.kind == "node" and key.component in VARIABLES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted rows and columns of all states."""
    lines, recorder = Lines(path), Recorder(path.name, keys)
    wanted = {str(key.number) for key in keys}
    names: tuple[str, ...] = ()
    at = ("", "")
    for line in lines:
        if "n o d a l" in line:
            at = _state(line, lines, recorder, at)
            names = ()
        elif line.startswith(" nodal point"):
            names = _columns(line, lines)
        elif not line.strip():
            names = ()
        elif names:
            number, _, rest = line.strip().partition(" ")
            if number in wanted:
                for name, value in zip(names, lines.numbers(rest, names), strict=True):
                    recorder.put(Key("node", name, int(number)), value)
    return recorded(recorder, lines, "blocks headed n o d a l   p r i n t   o u t")


def _state(line: str, lines: Lines, recorder: Recorder, before: tuple[str, str]) -> tuple[str, str]:
    """Begin a state; rotations follow under the same heading, and belong to the same state."""
    found = TIME.search(line)
    if found is None:
        raise lines.error("expected the number of the time step and ( at time T )")
    cycle, time = found.groups()
    if (cycle, time) != before:
        recorder.begin(time, lines)
    return cycle, time


def _columns(line: str, lines: Lines) -> tuple[str, ...]:
    """The quantities of the columns, by the head of the block."""
    head = COLUMN.findall(line)
    unknown = [quantity for _, quantity in head if quantity not in QUANTITIES]
    if unknown or not head:
        raise lines.error(
            f"unknown columns {', '.join(unknown) or line.strip()}; expected x-disp, y-disp, ..."
        )
    return tuple(f"{axis}-{QUANTITIES[quantity]}" for axis, quantity in head)
