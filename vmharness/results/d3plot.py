"""d3plot: states of the whole model in words of float32 or float64, in a family of files: d3plot, d3plot01, ...

Control words come first, then the geometry and the numbers of nodes, elements and parts; then states of equal length,
each with the time, global variables, nodes, and elements. A word of -999999 ends the states of a file. Only the wanted
words are read.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

import numpy as np

from vmharness.results._d3head import Model, is_end, model_of, reals, words_of
from vmharness.results._key import Key
from vmharness.results._lines import ResultError
from vmharness.results._series import Recorder, Series

NAME, DATABASE = "d3plot", "*DATABASE_BINARY_D3PLOT"
DIGITS = None  # those of float32 or float64
SCHEME = "positions, velocities and energies at t_n"

ENERGIES = ("kinetic", "internal", "total")
AXES = ("x", "y", "z")
STRESSES = tuple(f"{axes}-stress" for axes in ("xx", "yy", "zz", "xy", "yz", "zx"))
RESULTANTS = ("axial-force", "s-shear", "t-shear", "s-moment", "t-moment", "torsion")
CHUNK = 1 << 16  # bytes
MOTION = ("displacement", "coordinate", "velocity", "acceleration")


def recognises(name: str, head: bytes) -> bool:
    """By the kind of file in the control words."""
    return words_of(head) is not None


def gives(key: Key) -> bool:
    """Motion of nodes, energies, parts, stresses of solids, resultants of beams; shells are written in other axes."""
    axis, _, quantity = key.component.partition("-")
    return {
        "node": axis in AXES and quantity in MOTION,
        "energy": key.component in ENERGIES,
        "model": axis in AXES and quantity == "velocity",
        "part": key.component in ("internal", "kinetic", "hourglass")
        or (axis in AXES and quantity == "velocity"),
        "solid": key.point == 1 and key.component in (*STRESSES, "plastic-strain"),
        "beam": key.point == 0 and key.component in RESULTANTS,
    }.get(key.kind, False)


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted quantities of all states of the family; nothing of a file that is not its first."""
    with path.open("rb") as file:
        model = model_of(file, path.name)
        places = {key: place for key in keys if (place := _place(model, key)) is not None}
        size = _statewords_of(model) * model.words.size
        recorder = Recorder(path.name, list(places))
        notes = _states(file, path.name, model, model.states, size, places, recorder)
    for each in _family(path):
        with each.open("rb") as file:
            notes += _states(file, each.name, model, 0, size, places, recorder)
    single = model.words.size == 4
    series = recorder.series(path.name, expected="states")
    return [replace(series, digits=7.2 if single else 16.0, notes=(*series.notes, *notes))]


def _family(path: Path) -> list[Path]:
    """The files that continue the first one: its name and a number."""
    found = [each for each in path.parent.glob(f"{path.name}*") if each.name[len(path.name) :].isdigit()]
    return sorted(found, key=lambda each: int(each.name[len(path.name) :]))


def _nodal(model: Model) -> Iterator[tuple[str, int]]:
    """What a state has of each node, in its order: names, and words a node."""
    control = model.control
    if control["iu"]:
        yield "coordinate", 3
    yield "heat", {0: 0, 1: 1, 2: 4, 3: 6}.get(control["it"] % 10, 0)
    yield "mass", control["it"] // 10 % 10
    yield "gradient", control["idtdt"] % 10
    yield "residual", 6 * (control["idtdt"] // 10 % 10)
    if control["iv"]:
        yield "velocity", 3
    if control["ia"]:
        yield "acceleration", 3


def _statewords_of(model: Model) -> int:
    """Words of a state."""
    control = model.control
    shells = control["nel4"] - model.rigid_shells
    elements = abs(control["nel8"]) + control["nelt"] + control["nel4"] + control["nel2"]
    deleted = 0 if control["maxint"] >= 0 else elements if control["maxint"] <= -10000 else control["numnp"]
    return _behind_nodes(model) + sum(
        (
            abs(control["nel8"]) * control["nv3d"],
            control["nelt"] * control["nv3dt"],
            control["nel2"] * control["nv1d"],
            shells * control["nv2d"],
            deleted,
        )
    )


def _behind_nodes(model: Model) -> int:
    words = sum(count for _, count in _nodal(model))
    return 1 + model.control["nglbv"] + words * model.control["numnp"]


def _place(model: Model, key: Key) -> tuple[int, float] | None:
    """The word of a state that holds a quantity, and what is taken off it; None if the family does not have it."""
    control, component = model.control, key.component
    axis, _, quantity = component.partition("-")
    if key.kind in ("energy", "model"):
        word = ENERGIES.index(component) if key.kind == "energy" else 3 + AXES.index(axis)
        return (1 + word, 0.0) if word < control["nglbv"] else None
    rows = np.flatnonzero(model.ids[key.kind] == key.number)
    if not rows.size:
        return None
    row = int(rows[0])
    if key.kind == "node":
        return _of_node(model, row, AXES.index(axis), quantity)
    if key.kind == "part":
        return _of_part(model, row, component, axis)
    if key.kind == "solid":
        word, there = (*STRESSES, "plastic-strain").index(component), control["ioshl1"] == 1000
        if not there or control["nv3d"] < 7 or (word == 6 and control["ioshl2"] != 1000):
            return None
        return _behind_nodes(model) + row * control["nv3d"] + word, 0.0
    before = (
        _behind_nodes(model) + abs(control["nel8"]) * control["nv3d"] + control["nelt"] * control["nv3dt"]
    )
    return before + row * control["nv1d"] + RESULTANTS.index(component), 0.0


def _of_node(model: Model, row: int, axis: int, quantity: str) -> tuple[int, float] | None:
    """A displacement is the coordinate less that of the geometry."""
    begin, sought = 1 + model.control["nglbv"], "coordinate" if quantity == "displacement" else quantity
    for name, count in _nodal(model):
        if name == sought:
            off = float(model.x0[row, axis]) if quantity == "displacement" else 0.0
            return begin + 3 * row + axis, off
        begin += count * model.control["numnp"]
    return None


def _of_part(model: Model, row: int, component: str, axis: str) -> tuple[int, float] | None:
    parts = model.control["nmmat"]
    begin = {"internal": 0, "kinetic": parts, "hourglass": 6 * parts}.get(component, 2 * parts)
    word = begin + (3 * row + AXES.index(axis) if axis in AXES else row)
    return (1 + 6 + word, 0.0) if 6 + word < model.control["nglbv"] else None


def _states(
    file: BinaryIO,
    name: str,
    model: Model,
    start: int,
    size: int,
    places: Mapping[Key, tuple[int, float]],
    recorder: Recorder,
) -> list[str]:
    """Keep the wanted words of the states in a file; returns a note if it ends within a state."""
    words, end, at = model.words, file.seek(0, 2), start
    while at + words.size <= end and not is_end(file, words, at // words.size):
        if at + size > end:
            return (
                []
                if _is_empty(file, at, end)
                else [f"{name}: the file ends within a state, which is left out"]
            )
        t = float(reals(file, words, at // words.size, 1, name)[0])
        if t == 0.0 and _is_empty(file, at, end):  # the rest of a block
            break
        place = f"{name}: the state at t = {t:g}"
        recorder.state(t, place, 8 if words.size == 4 else 17)
        for key, (word, off) in places.items():
            value = float(reals(file, words, at // words.size + word, 1, name)[0]) - off
            if not np.isfinite(value):
                raise ResultError(f"{place}: {key} is {value}: the run has diverged, or the file is damaged")
            recorder.put(key, value)
        at += size
    return []


def _is_empty(file: BinaryIO, first: int, last: int) -> bool:
    """Whether there are only zeros."""
    file.seek(first)
    return not any(any(file.read(min(CHUNK, last - place))) for place in range(first, last, CHUNK))
