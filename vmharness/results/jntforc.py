"""jntforc: forces of joints. Lines ` x-force......................%14.5E` for each joint of each state.

Forces in the axes of a joint, marked `(local)`, are passed over.
"""

from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import DOTTED, Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "jntforc", "*DATABASE_JNTFORC"
DIGITS = 6.0
SCHEME = "forces at t_n, in global axes"

NUMBER = "joint number"
QUANTITIES = tuple(f"{axis}-{kind}" for kind in ("force", "moment") for axis in "xyz")

VARIABLES = {name: name.replace("-", "_") for name in QUANTITIES}


def recognises(name: str, head: bytes) -> bool:
    """By its first lines, or by the name."""
    return b" joint number......" in head or (name.startswith("jntforc") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Forces and moments of joints."""
    return key.kind == "joint" and key.component in QUANTITIES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted forces of all states."""
    lines, recorder, number = Lines(path), Recorder(path.name, keys), 0
    for line in lines:
        found = DOTTED.match(line)
        if found is None:
            continue
        name, text = found.groups()
        if name == "time":
            recorder.begin(text, lines)
        elif name == NUMBER:
            number = lines.integer(text, "the number of the joint")
        elif (key := Key("joint", name, number)) in keys:
            recorder.put(key, lines.number_of(text, f"{name} of joint {number}"))
    return recorded(recorder, lines, f"lines such as ` {NUMBER}.................         1`")
