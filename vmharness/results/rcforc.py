"""rcforc: resultant forces of contacts. A line for each side: `  slave %11d time%12.5E  x %12.5E  y ...`.

Newer files write SURFA and SURFB for slave and master, and moments behind the mass.
"""

import re
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "rcforc", "*DATABASE_RCFORC"
DIGITS = 6.0
SCHEME = "forces at t_n, on side A"

SIDE = re.compile(r"\s*(slave|surfa)\s*(\d+)\s*time(.*)", re.IGNORECASE)
FORCES = re.compile(r"\s*([^\sx]+)\s*x\s*([^\sy]+)\s*y\s*([^\sz]+)\s*z\s*([^\sm]+)")
NAMES = ("the time", "x", "y", "z")

VARIABLES = {f"{axis}-force": f"{axis}_force" for axis in "xyz"}


def recognises(name: str, head: bytes) -> bool:
    """By its lines, or by the name."""
    return re.search(rb"\n\s*(slave|SURFA)\s*\d+\s*time", head) is not None or (
        name.startswith("rcforc") and b"\0" not in head
    )


def gives(key: Key) -> bool:
    """Forces of contacts."""
    return key.kind == "contact" and key.component in VARIABLES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted forces of all states."""
    lines, recorder, at = Lines(path), Recorder(path.name, keys), ""
    for line in lines:
        side = SIDE.match(line)
        if side is None:
            continue
        found = FORCES.match(side.group(3))
        if found is None:
            raise lines.error("expected `time T  x FX  y FY  z FZ` behind the number of the contact")
        number, texts = int(side.group(2)), found.groups()
        mine = [Key("contact", f"{axis}-force", number) for axis in "xyz"]
        if texts[0] != at or any(map(recorder.has, mine)):
            at = texts[0]
            recorder.begin(at, lines)
        for key, name, text in zip(mine, NAMES[1:], texts[1:], strict=True):
            if key in keys:
                recorder.put(key, lines.number_of(text, f"{name}-force of contact {number}"))
    return recorded(recorder, lines, "lines such as `  slave           1 time 1.00000E-03  x ...`")
