"""binout: the databases of LS-DYNA in one binary file; `VARIABLES` of the text formats are names of its variables.

A directory for each database has `metadata`, with the numbers of its things, and a directory for each state. Files that
continue another have its name and `%001`, ...; they are read with it.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vmharness.results import bndout, deforc, glstat, jntforc, matsum, nodout, rbdout, rcforc, rwforc
from vmharness.results._key import Key
from vmharness.results._lines import ResultError
from vmharness.results._lsda import Lsda, Variable, is_lsda
from vmharness.results._series import Recorder, Series

NAME, DATABASE = "binout", ""  # those of the text files
DIGITS = None  # those of float32 or float64
SCHEME = "as in the text files"

Numbers = NDArray[np.generic]
NUMBERS = {
    "ids",
    "side",
    "single_sided",
    "force_ids",
    "moment_ids",
    "nip",
}  # variables that say which row is whose
SMALL = float(np.float32(glstat.ZERO))  # what stands for an energy that is zero
DIGITS_OF, RESOLUTION_OF = {9: 7.2, 10: 16.0}, {9: 8, 10: 17}  # of the types float32 and float64
STRESSES = {f"{axes}-stress": f"sig_{axes}" for axes in ("xx", "yy", "zz", "xy", "yz", "zx")}
RESULTANTS = {
    "axial-force": "axial", "s-shear": "shear_s", "t-shear": "shear_t", "s-moment": "moment_s",
    "t-moment": "moment_t", "torsion": "torsion",
}  # fmt: skip
TOTALS = {name: name.replace("_force", "_resultant") for name in rcforc.VARIABLES.values()}

# Directory of the states, by kind of thing: the variables of its components.
PLACES: Mapping[str, tuple[str, Mapping[str, str]]] = {
    "node": ("/nodout", nodout.VARIABLES),
    "energy": ("/glstat", glstat.VARIABLES),
    "model": ("/glstat", glstat.VARIABLES),
    "part": ("/matsum", matsum.VARIABLES),
    "contact": ("/rcforc", rcforc.VARIABLES),
    "support": ("/spcforc", jntforc.VARIABLES),
    "wall": ("/rwforc/forces", rwforc.VARIABLES),
    "discrete": ("/deforc", deforc.VARIABLES),
    "joint": ("/jntforc/joints", jntforc.VARIABLES),
    "rigid": ("/rbdout", rbdout.VARIABLES),
    "driven node": ("/bndout/velocity/nodes", bndout.VARIABLES),
    "solid": ("/elout/solid", STRESSES),
    "shell": ("/elout/shell", {**STRESSES, "plastic-strain": "plastic_strain"}),
    "beam": ("/elout/beam", RESULTANTS),
}
CONTACT_ENERGY = "/sleout"


def recognises(name: str, head: bytes) -> bool:
    """By the first bytes."""
    return is_lsda(head)


def gives(key: Key) -> bool:
    """Whatever the databases have."""
    return key.kind in PLACES and (key.component in PLACES[key.kind][1] or _directory(key) == CONTACT_ENERGY)


def _directory(key: Key) -> str:
    return CONTACT_ENERGY if (key.kind, key.component) == ("contact", "energy") else PLACES[key.kind][0]


@dataclass
class _Database:
    """A directory of states: what is wanted of it, and the state that is being read."""

    recorder: Recorder
    numbers: dict[str, Numbers] = field(default_factory=dict)  # metadata, by name
    state: dict[str, Variable] = field(default_factory=dict)
    name: str = ""  # of the directory of the state
    type: int = 9  # of the values


def read(path: Path, keys: set[Key]) -> list[Series]:
    """The wanted quantities of all states: a series for each database. Nothing of a file that continues another."""
    base = path.with_name(path.name.partition("%")[0])
    if base != path and base.exists():
        return []
    found: dict[str, _Database] = {}
    for place in {_directory(key) for key in keys}:
        found[place] = _Database(Recorder(path.name, [key for key in keys if _directory(key) == place]))
    notes, solver = [], ""
    for each in [path, *sorted(path.parent.glob(f"{path.name}%*"))]:
        with each.open("rb") as file:
            lsda = Lsda(file, each.name)
            for variable in lsda.variables():
                solver = solver or _solver(lsda, variable)
                _take(lsda, variable, found)
            for database in found.values():
                _finish(lsda, database)
            notes += [lsda.cut] if lsda.cut else []
    return [
        replace(each, digits=DIGITS_OF.get(database.type), notes=(*each.notes, *notes), solver=solver)
        for database, each in _series(found.values(), path)
    ]


def _series(found: Iterable[_Database], path: Path) -> Iterator[tuple[_Database, Series]]:
    for database in found:
        if database.recorder.t is not None:
            yield database, database.recorder.series(path.name)


def _solver(lsda: Lsda, variable: Variable) -> str:
    is_version = variable.name == "version" and variable.directory.endswith("/metadata")
    return f"LS-DYNA {lsda.text(variable)}" if is_version else ""


def _take(lsda: Lsda, variable: Variable, found: Mapping[str, _Database]) -> None:
    """Note where a variable of a wanted database is; a new state ends the one before."""
    place, _, leaf = variable.directory.rpartition("/")
    database = found.get(place)
    if database is None:
        return
    if leaf == "metadata" and variable.name in NUMBERS:
        database.numbers[variable.name] = lsda.read(variable)
    elif leaf[:1] == "d" and leaf[1:].isdigit():
        if leaf != database.name:
            _finish(lsda, database)
            database.name = leaf
        database.state[variable.name] = variable


def _finish(lsda: Lsda, database: _Database) -> None:
    """Read the wanted values of the state that ends."""
    state, database.state = database.state, {}
    if not state:
        return
    place = f"{lsda.name}: {next(iter(state.values())).directory}"
    if "time" not in state:
        raise ResultError(f"{place} has no time")
    time, recorder = state["time"], database.recorder
    recorder.state(float(lsda.read(time, 0, 1)[0]), place, RESOLUTION_OF.get(time.type, 17))
    for name in NUMBERS & state.keys():  # of elements: those that are there
        database.numbers[name] = lsda.read(state[name])
    for key in recorder.keys:
        for variable, index in _places(database.numbers, state, key):
            value = float(lsda.read(variable, index, 1)[0])
            if not np.isfinite(value):
                raise ResultError(f"{place}: {key} is {value}: the run has diverged, or the file is damaged")
            recorder.add(key, 0.0 if key.kind == "energy" and value == SMALL else value)
            database.type = variable.type


def _places(
    numbers: Mapping[str, Numbers], state: Mapping[str, Variable], key: Key
) -> Iterator[tuple[Variable, int]]:
    """The variables of a state, and the places in them, whose values add up to a quantity; none if it is not there."""
    if _directory(key) == CONTACT_ENERGY:
        yield from _sides(numbers, state, key.number)
        return
    name = PLACES[key.kind][1][key.component]
    if key.kind == "support":
        name = name if key.number else TOTALS.get(name, "")
    variable = state.get(name) or state.get(name.replace("_force", "force"))  # older bndout: xforce
    if variable is None:
        return
    if key.kind in ("energy", "model") or not key.number:
        yield from ((variable, index) for index in range(variable.count))  # several walls are added
        return
    for index in _rows(numbers, key, name):
        if index < variable.count:
            yield variable, index


def _rows(numbers: Mapping[str, Numbers], key: Key, name: str) -> list[int]:
    """The places of a thing: of an integration point, where there are several; of a contact's side A."""
    ids = (
        numbers.get("moment_ids" if "moment" in name else "force_ids")
        if key.kind == "support"
        else numbers.get("ids")
    )
    if ids is None:
        return []
    here = ids == key.number
    if key.kind == "contact" and "side" in numbers:
        here &= numbers["side"] == 0
    rows = np.flatnonzero(here).tolist()
    if "nip" not in numbers or not key.point:
        return rows
    first = np.concatenate([[0], np.cumsum(numbers["nip"])])
    return [int(first[row]) + key.point - 1 for row in rows if key.point <= numbers["nip"][row]]


def _sides(
    numbers: Mapping[str, Numbers], state: Mapping[str, Variable], contact: int
) -> Iterator[tuple[Variable, int]]:
    """Both sides of a contact's energy; a single surface has no side B, and no place in its list."""
    ids, single = numbers.get("ids"), numbers.get("single_sided")
    for row in [] if ids is None else np.flatnonzero(ids == contact).tolist():
        yield state["slave"], row
        if "master" in state and (single is None or not single[row]):
            yield state["master"], row if single is None else row - int(np.count_nonzero(single[:row]))
