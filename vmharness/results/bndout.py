"""bndout: forces of prescribed motions. Sections for each instant; ` nd#%8d  xforce=%13.4E   yforce=...` for each node.

Only the section of prescribed motions is read. The time has four digits: with many states, some have the same.
"""

import re
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "bndout", "*DATABASE_BNDOUT"
DIGITS = 5.0
SCHEME = "forces at t_n, on the nodes"

STATE = re.compile(r"\s*n o d a l   f o r c e/e n e r g y\s+o u t p u t\s+t=\s*(\S+)")
NODE = re.compile(r"\s*nd#\s*(\d+)\s+xforce=\s*(\S+)\s+yforce=\s*(\S+)\s+zforce=\s*(\S+)")
SECTION = re.compile(
    r"\s*(velocity boundary condition|discrete nodal point|pressure boundary condition) forces"
)
DRIVEN = "velocity boundary condition"

VARIABLES = {f"{axis}-force": f"{axis}_force" for axis in "xyz"}


def recognises(name: str, head: bytes) -> bool:
    """By the heading of a state, or by the name."""
    return b"n o d a l   f o r c e/e n e r g y" in head or (name.startswith("bndout") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Forces that drive nodes."""
    return key.kind == "driven node" and key.component in VARIABLES


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted forces of all states."""
    lines, recorder = Lines(path), Recorder(path.name, keys)
    at, time, section = "", "", ""
    for line in lines:
        if found := STATE.match(line):
            time, section = found.group(1), ""
        elif found := SECTION.match(line):
            section = found.group(1)
        elif section == DRIVEN and (found := NODE.match(line)):
            number, *texts = found.groups()
            mine = [Key("driven node", f"{axis}-force", int(number)) for axis in "xyz"]
            if time != at or any(map(recorder.has, mine)):
                at = time
                recorder.begin(at, lines)
            for key, text in zip(mine, texts, strict=True):
                if key in keys:
                    recorder.put(key, lines.number_of(text, f"{key}"))
    return recorded(recorder, lines, "sections of velocity boundary condition forces")
