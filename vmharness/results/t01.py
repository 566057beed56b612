"""T01 of OpenRadioss: energies, parts and nodes over time, in Fortran records of big-endian float32.

Records of titles come first, and the numbers of the variables of parts and of groups of /TH; then for each instant
a record with the time, one with all global variables, one with those of the parts, one with those of the subsets, and
one for each group. Velocities are those of the middle of the step that ends at the time of the record: they are given
at that instant.
"""

import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import BinaryIO

import numpy as np

from vmharness.results._key import Key
from vmharness.results._lines import ResultError
from vmharness.results._series import Recorder, Series

NAME, DATABASE = "T01", ""  # of another solver: no keyword of LS-DYNA asks for it
DIGITS = 7.2
SCHEME = "positions and energies at t_n; velocities of n - 1/2, given at t_n - dt/2"

TITLE = 84  # bytes of the first record: a number of the version, and a title
NODES = 0  # type of a group
TIME_STEP = 7  # number of the global variable
ROUND = 8  # decimal digits of a time
GLOBAL: Mapping[Key, tuple[int, ...]] = {  # numbers of the variables that are added
    Key("energy", "internal"): (1,),
    Key("energy", "kinetic"): (2, 8),  # of translation and of rotation
    Key("energy", "external work"): (9,),
    Key("energy", "spring and damper"): (10,),
    Key("energy", "sliding"): (11,),
    Key("energy", "hourglass"): (12,),
    **{Key("model", f"{axis}-momentum"): (3 + place,) for place, axis in enumerate("xyz")},
}
PART = {"internal": 1, "kinetic": 2, "x-momentum": 3, "y-momentum": 4, "z-momentum": 5, "hourglass": 7}
NODE = {
    f"{axis}-{quantity}": first + place
    for quantity, first in (("displacement", 1), ("velocity", 4), ("acceleration", 7), ("coordinate", 16))
    for place, axis in enumerate("xyz")
}


def recognises(name: str, head: bytes) -> bool:
    """By the first record."""
    if len(head) < 8:
        return False
    length, version = struct.unpack(">ii", head[:8])
    return length == TITLE and 3000 <= version < 10000


def gives(key: Key) -> bool:
    """Energies, momenta, parts and the motion of nodes."""
    return key in GLOBAL or key.component in {"part": PART, "node": NODE}.get(key.kind, {})


@dataclass(frozen=True)
class _Layout:
    """What a record of an instant holds: the bytes of it, and the places of quantities."""

    start: int  # of the first instant, in the file
    size: int
    places: Mapping[Key, tuple[int, ...]]  # offsets in an instant of the values to add
    step: int  # offset of the time step; 0 if it is not there


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted quantities of all instants: velocities as a series of its own."""
    with path.open("rb") as file:
        layout = _layout(file, path.name)
        wanted = {key: layout.places[key] for key in keys if key in layout.places}
        found = Recorder(path.name, [key for key in wanted if not _is_velocity(key)])
        moving = Recorder(path.name, [key for key in wanted if _is_velocity(key)])
        number = 0
        for number, content in enumerate(_instants(file, layout, path.name), 1):
            _take(content, f"{path.name}: instant {number}", layout, wanted, found, moving)
        left = file.seek(0, 2) - layout.start - number * layout.size
    note = f"{path.name}: the file ends within instant {number + 1}, which is left out"
    series = [each.series(path.name, expected="records of instants") for each in (found, moving) if each.keys]
    return [
        replace(each, solver="OpenRadioss", notes=(*each.notes, *([note] if left else []))) for each in series
    ]


def _is_velocity(key: Key) -> bool:
    return key.kind == "node" and key.component.endswith("-velocity")


def _take(
    content: bytes,
    place: str,
    layout: _Layout,
    wanted: Mapping[Key, tuple[int, ...]],
    found: Recorder,
    moving: Recorder,
) -> None:
    """Keep the wanted values of an instant."""
    (t,) = struct.unpack_from(">f", content, 4)
    half = struct.unpack_from(">f", content, layout.step)[0] / 2.0 if layout.step and t else 0.0
    found.state(t, place, ROUND)
    moving.state(t - half, place, ROUND)
    for key, offsets in wanted.items():
        value = sum(struct.unpack_from(">f", content, offset)[0] for offset in offsets)
        if not np.isfinite(value):
            raise ResultError(f"{place}: {key} is {value}: the run has diverged, or the file is damaged")
        (moving if _is_velocity(key) else found).put(key, value)


def _instants(file: BinaryIO, layout: _Layout, name: str) -> Iterator[bytes]:
    file.seek(layout.start)
    while len(content := file.read(layout.size)) == layout.size:
        if content[:4] != content[8:12]:
            raise ResultError(f"{name}: expected the record of a time at byte {file.tell() - layout.size}")
        yield content


def _layout(file: BinaryIO, name: str) -> _Layout:
    """Read the head of the file; raises ResultError where its records are not those of a time history."""
    _record(file, name)  # version and title
    _record(file, name)  # date and release
    first = _record(file, name)
    while len(first) != 24:  # further records of newer versions: their number, length of titles, units
        first = _record(file, name)
    counts = struct.unpack(">6i", first)
    if min(counts) < 0:
        raise ResultError(
            f"{name}: negative numbers of parts, materials, sections, subsets, groups, variables: {counts}"
        )
    parts, materials, sections, subsets, groups, globals_ = counts
    if globals_:
        _record(file, name)
    places: dict[Key, list[int]] = {}
    at = 12 + 4  # behind the record of the time, and the length of the next one
    for key, numbers in GLOBAL.items():
        if max(numbers) <= globals_:
            places[key] = [at + 4 * (number - 1) for number in numbers]
    step = at + 4 * (TIME_STEP - 1) if globals_ >= TIME_STEP else 0
    at += 4 * globals_ + 4 if globals_ else -4
    at = _parts(file, name, parts, at, places)
    for _ in range(materials + sections):
        _record(file, name)
    at = _subsets(file, name, subsets, at)
    for _ in range(groups):
        at = _group(file, name, at, places)
    return _Layout(file.tell(), at, {key: tuple(offsets) for key, offsets in places.items()}, step)


def _parts(file: BinaryIO, name: str, count: int, at: int, places: dict[Key, list[int]]) -> int:
    """Note the places of parts; returns where the next record of an instant begins."""
    begin, words = at + 4, 0
    for _ in range(count):
        head = _record(file, name)
        number, variables = _first(head, 1, name)[0], _first(head[-4:], 1, name)[0]
        codes = _first(_record(file, name), variables, name) if variables else ()
        for component, code in PART.items():
            if code in codes:
                places[Key("part", component, number)] = [begin + 4 * (words + codes.index(code))]
        words += variables
    return begin + 4 * words + 4 if words else at


def _subsets(file: BinaryIO, name: str, count: int, at: int) -> int:
    words = 0
    for _ in range(count):
        _, _, children, parts, variables = _first(_record(file, name), 5, name)
        for numbers in (children, parts, variables):
            if numbers:
                _record(file, name)
        words += variables
    return at + 4 * words + 8 if words else at


def _group(file: BinaryIO, name: str, at: int, places: dict[Key, list[int]]) -> int:
    """Note the places of the nodes of a group; returns where the next record of an instant begins."""
    _, kind, _, count, variables = _first(_record(file, name), 5, name)
    numbers = [_first(_record(file, name), 1, name)[0] for _ in range(count)]
    codes = _first(_record(file, name), variables, name) if variables else ()
    if kind == NODES:
        for row, number in enumerate(numbers):
            for component, code in NODE.items():
                if code in codes:
                    word = row * variables + codes.index(code)
                    places[Key("node", component, number)] = [at + 4 + 4 * word]
    return at + 8 + 4 * count * variables


def _first(content: bytes, count: int, name: str) -> tuple[int, ...]:
    """The first integers of a record; raises ResultError if it has fewer."""
    if not 0 <= 4 * count <= len(content):
        raise ResultError(
            f"{name}: a record of the head has {len(content)} bytes, where {count} numbers are expected"
        )
    return struct.unpack_from(f">{count}i", content)


def _record(file: BinaryIO, name: str) -> bytes:
    """The content of the next record; raises ResultError if it is not complete."""
    at = file.tell()
    head = file.read(4)
    length = struct.unpack(">i", head)[0] if len(head) == 4 else -1
    content = file.read(max(length, 0))
    if length < 0 or len(content) != length or file.read(4) != head:
        raise ResultError(f"{name}: the record at byte {at} is not complete, within the head of the file")
    return content
