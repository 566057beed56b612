"""elout: stresses of elements, in blocks for solids, shells and beams of each state.

Solids and shells: a line `%8d-%7d` with element and material, then a row for each integration point: its number, its
state in a word, and stresses as `%12.4E`. Beams: resultants as `%11.3E`, and stresses of integration points.
Stresses of shells are used if they are in the axes of the element, which the head calls `(local)`.
"""

import re
from dataclasses import replace
from pathlib import Path

from vmharness.results._key import Key
from vmharness.results._lines import Lines
from vmharness.results._series import Recorder, Series

NAME, DATABASE = "elout", "*DATABASE_ELOUT, and the element in *DATABASE_HISTORY_SOLID, _SHELL or _BEAM"
DIGITS = None  # 5 of stresses, 4 of the resultants of beams
SCHEME = "stresses at t_n"

STATE = re.compile(r"s t e p\s*\d+\s*\( at time\s*(\S+?)\s*\)")
ELEMENT = re.compile(r"\s*(\d+)-\s*(\d+)\s*$")
POINT = re.compile(r"\s*(\d+)(?:-\s*\d+)?\s+(?:[a-zA-Z]+\s+)?(.*)")
BEAM = re.compile(r"\s*beam/truss # =\s*(\d+)")
STRESSES = tuple(f"{axes}-stress" for axes in ("xx", "yy", "zz", "xy", "yz", "zx"))
RESULTANTS = ("axial-force", "s-shear", "t-shear", "s-moment", "t-moment", "torsion")
FIBRES = ("axial-stress", "xy-stress", "zx-stress", "plastic-strain")
DIGITS_OF = {"solid": 5.0, "shell": 5.0, "beam": 4.0}
COLUMNS = {"solid": (*STRESSES, "effsg", "yield"), "shell": (*STRESSES, "plastic-strain")}


def recognises(name: str, head: bytes) -> bool:
    """By the heading of a block, or by the name."""
    headings = (b"e l e m e n t   s t r e s s", b"r e s u l t a n t s   a n d   s t r e s s e s")
    return any(heading in head for heading in headings) or (name.startswith("elout") and b"\0" not in head)


def gives(key: Key) -> bool:
    """Stresses of solids and shells; resultants and stresses of beams."""
    if key.kind == "beam":
        return key.component in (FIBRES if key.point else RESULTANTS)
    return key.kind in COLUMNS and key.component in COLUMNS[key.kind][: 6 if key.kind == "solid" else 7]


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted stresses of all states: a series for each kind of element, for each has its own blocks."""
    kinds = {key.kind for key in keys}
    reading = _Reading(
        Lines(path), {kind: Recorder(path.name, [k for k in keys if k.kind == kind]) for kind in kinds}
    )
    for line in reading.lines:
        reading.take(line)
    lines = reading.lines
    found = [
        (kind, recorder.series(lines.place, lines.cut, lines.solver))
        for kind, recorder in reading.recorders.items()
        if recorder.t is not None
    ]
    return [replace(series, digits=DIGITS_OF[kind]) for kind, series in found]


class _Reading:
    """Where the reader is: in which block, and at which element."""

    def __init__(self, lines: Lines, recorders: dict[str, Recorder]) -> None:
        self.lines, self.recorders = lines, recorders
        self.time = ""  # of the heading, until the kind of the block is known
        self.kind, self.eid, self.row = "", 0, ""

    def take(self, line: str) -> None:
        """Read a line."""
        if "s t e p" in line and (found := STATE.search(line)):
            self.time, self.kind, self.row = found.group(1), "", ""
            if "r e s u l t a n t s" in line:
                self._begin("beam")
            elif "s t r a i n" in line:
                self.time = ""
        elif "stress       sig-xx" in line:
            self._begin("shell" if "ipt-shl" in line else "solid")
        elif line.startswith((" strains", " element  strain")) or "materl(global" in line.replace(" ", ""):
            self.kind = self.time = ""
        elif not line.strip():
            self._blank()
        elif self.kind == "beam":
            self._beam(line)
        elif self.kind:
            self._point(line)

    def _begin(self, kind: str) -> None:
        """Begin a state of this kind of element, if it is wanted."""
        if self.time and kind in self.recorders:
            self.kind, recorder = kind, self.recorders[kind]
            if (
                recorder.t is None or self.lines.time_of(self.time) != recorder.t
            ):  # thick shells have another block
                recorder.begin(self.time, self.lines)

    def _blank(self) -> None:
        """A block of solids or shells ends, or the points of a beam."""
        if self.kind != "beam":
            self.kind = ""
        elif self.row == "points":
            self.row = ""

    def _point(self, line: str) -> None:
        if found := ELEMENT.match(line):
            self.eid = int(found.group(1))
        elif found := POINT.match(line):
            recorder, names = self.recorders[self.kind], COLUMNS[self.kind]
            mine = [Key(self.kind, name, self.eid, int(found.group(1))) for name in names]
            if not recorder.keys.isdisjoint(mine):
                for key, value in zip(mine, self.lines.numbers(found.group(2), names), strict=True):
                    recorder.put(key, value)

    def _beam(self, line: str) -> None:
        if found := BEAM.match(line):
            self.eid, self.row = int(found.group(1)), ""
        elif line.startswith(" resultants "):
            self.row = "resultants"
        elif line.startswith(" integration point"):
            self.row = "points"
        elif self.row == "resultants":
            self._put(RESULTANTS, 0, line)
            self.row = ""
        elif self.row == "points" and (found := POINT.match(line)) and "sigma" not in line:
            self._put(FIBRES, int(found.group(1)), found.group(2))

    def _put(self, names: tuple[str, ...], point: int, text: str) -> None:
        recorder = self.recorders["beam"]
        mine = [Key("beam", name, self.eid, point) for name in names]
        if not recorder.keys.isdisjoint(mine):
            for key, value in zip(mine, self.lines.numbers(text, names), strict=True):
                recorder.put(key, value)
