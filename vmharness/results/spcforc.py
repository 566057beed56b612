"""spcforc: reactions of supports. ` output at time =%14.5E`, then ` node=%8d local x,y,z forces =%14.4E...`."""

import re
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series, recorded

NAME, DATABASE = "spcforc", "*DATABASE_SPCFORC, and supports by *BOUNDARY_SPC"
DIGITS = 5.0
SCHEME = "reactions at t_n, on the nodes"

NODE = re.compile(r"\s*node=\s*(\d+)\s*local x,y,z (force|moment)s?\s*=(.*?)(?:setid.*)?$")
TOTAL = re.compile(r"\s*force resultants\s*=(.*)")
QUANTITIES = [f"{axis}-{kind}" for kind in ("force", "moment") for axis in "xyz"]


def recognises(name: str, head: bytes) -> bool:
    """By its first lines, or by the name."""
    return b" local x,y,z forces =" in head or (name.startswith("spcforc") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Reactions at nodes, and the sum of all forces."""
    return key.kind == "support" and key.component in (QUANTITIES if key.number else QUANTITIES[:3])


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted reactions of all states."""
    lines, recorder = Lines(path), Recorder(path.name, keys)
    for line in lines:
        if line.startswith(" output at time ="):
            text = line.partition("=")[2].strip()
            recorder.begin(text, lines)
        elif found := NODE.match(line):
            _put(int(found.group(1)), found.group(2), found.group(3), lines, recorder)
        elif found := TOTAL.match(line):
            _put(0, "force", found.group(1), lines, recorder)
    return recorded(recorder, lines, "` output at time =` and ` node=... local x,y,z forces =`")


def _put(node: int, kind: str, text: str, lines: Lines, recorder: Recorder) -> None:
    """Three components of a node, or of the sum; raises ResultError if they are there already."""
    mine = [Key("support", f"{axis}-{kind}", node) for axis in "xyz"]
    if recorder.keys.isdisjoint(mine):
        return
    if any(map(recorder.has, mine)):
        raise lines.error(f"a second reaction of node {node} at the same time; expected one for each node")
    names = tuple(f"{axis}-{kind}" for axis in "xyz")
    for key, value in zip(mine, lines.numbers(text, names), strict=True):
        recorder.put(key, value)
