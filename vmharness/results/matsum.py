"""matsum: energies, momentum and velocity of parts. A time, then a block of `name=%13.4E` for each part."""

import re
from collections.abc import Mapping
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "matsum", "*DATABASE_MATSUM"
DIGITS = 5.0
SCHEME = "energies and momenta at t_n"

PAIR = re.compile(r"([+A-Za-z][\w.#-]*)=\s*(\S+)")
PART = "mat.#"
QUANTITIES: Mapping[str, str] = {
    "inten": "internal", "kinen": "kinetic", "hgeng": "hourglass",
    "x-mom": "x-momentum", "y-mom": "y-momentum", "z-mom": "z-momentum",
    "x-rbv": "x-velocity", "y-rbv": "y-velocity", "z-rbv": "z-velocity",
}  # fmt: skip

VARIABLES = {
    **{name: f"{name}_energy" for name in ("internal", "kinetic", "hourglass")},
    **{f"{axis}-momentum": f"{axis}_momentum" for axis in "xyz"},
    **{f"{axis}-velocity": f"{axis}_rbvelocity" for axis in "xyz"},
}


def recognises(name: str, head: bytes) -> bool:
    """By its first lines, or by the name."""
    return b" mat.#=" in head or (name.startswith("matsum") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Energies and motion of parts."""
    return key.kind == "part" and key.component in VARIABLES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted quantities of all states."""
    lines, recorder, part = Lines(path), Recorder(path.name, keys), 0
    for line in lines:
        if line.startswith(" time ="):
            text = line.partition("=")[2].strip()
            recorder.begin(text, lines)
            continue
        for name, text in PAIR.findall(line) if "=" in line else ():
            if name == PART:
                part = lines.integer(text, "the number of the part")
            elif name in QUANTITIES and (key := Key("part", QUANTITIES[name], part)) in keys:
                recorder.put(key, lines.number_of(text, name))
    return recorded(recorder, lines, "` time =` and blocks that begin with ` mat.#=`")
