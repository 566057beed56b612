"""deforc: forces of springs and dampers. Lines ` resultant force..............%14.5E` for each element of each state.

The force is positive in tension, the change in length positive if the element is longer.
"""

from collections.abc import Mapping
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import DOTTED, Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "deforc", "*DATABASE_DEFORC"
DIGITS = 6.0
SCHEME = "forces and lengths at t_n"

NUMBER = "spring/damper number"
QUANTITIES: Mapping[str, str] = {
    "resultant force": "force",
    "change in length": "elongation",
    "resultant moment": "moment",
    "relative rotation": "rotation",
}

VARIABLES = {"force": "resultant_force", "elongation": "displacement"}


def recognises(name: str, head: bytes) -> bool:
    """By its first lines, or by the name."""
    return b" spring/damper number....." in head or (name.startswith("deforc") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Forces and lengths of springs and dampers."""
    return key.kind == "discrete" and key.component in QUANTITIES.values()


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted quantities of all states."""
    lines, recorder, number = Lines(path), Recorder(path.name, keys), 0
    for line in lines:
        found = DOTTED.match(line)
        if found is None:
            continue
        name, text = found.groups()
        if name == "time":
            recorder.begin(text, lines)
        elif name == NUMBER:
            number = lines.integer(text, "the number of the spring or damper")
        elif name in QUANTITIES and (key := Key("discrete", QUANTITIES[name], number)) in keys:
            recorder.put(key, lines.number_of(text, f"{name} of element {number}"))
    return recorded(recorder, lines, f"lines such as ` {NUMBER}.........         1`")
