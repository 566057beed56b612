"""glstat: energies of the whole model. A line for each, ` kinetic energy.................%14.5E`."""

from collections.abc import Mapping
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import DOTTED, Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "glstat", "*DATABASE_GLSTAT"
DIGITS = 6.0
SCHEME = "energies at t_n, the kinetic energy of velocities at t_n"

ZERO = 1e-20  # what LS-DYNA prints for some energies that are zero
ENERGIES: Mapping[str, str] = {
    "kinetic": "kinetic energy",
    "internal": "internal energy",
    "rigid wall": "stonewall energy",  # one line for each wall
    "spring and damper": "spring and damper energy",
    "hourglass": "hourglass energy",
    "damping": "system damping energy",
    "sliding": "sliding interface energy",
    "external work": "external work",
    "total": "total energy",
    "ratio": "total energy / initial energy",
}
LINES = {line: Key("energy", name) for name, line in ENERGIES.items()} | {
    f"global {axis} velocity": Key("model", f"{axis}-velocity") for axis in "xyz"
}

VARIABLES = {name: line.replace(" ", "_") for name, line in ENERGIES.items()} | {
    "ratio": "energy_ratio", **{f"{axis}-velocity": f"global_{axis}_velocity" for axis in "xyz"}
}  # fmt: skip


def recognises(name: str, head: bytes) -> bool:
    """By its first lines, or by the name."""
    return b" kinetic energy......" in head or (name.startswith("glstat") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Energies of the model, and the velocity of its centre of mass."""
    return key in LINES.values()


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted energies of all states."""
    lines, recorder = Lines(path), Recorder(path.name, keys)
    for line in lines:
        found = DOTTED.match(line)
        if found is None:
            continue
        name, text = found.groups()
        if name == "time":
            recorder.begin(text, lines)
        elif (key := LINES.get(name)) in keys and key is not None:
            value = lines.number_of(text, name)
            recorder.add(key, 0.0 if value == ZERO else value)
    return recorded(recorder, lines, "lines such as ` time...........................   1.00000E-03`")
