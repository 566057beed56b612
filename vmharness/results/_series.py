"""Quantities over time, as a file holds them; restarts, and files that end within a state."""

from array import array
from bisect import bisect_left
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from vmharness.results._key import Key
from vmharness.results._lines import Lines, ResultError, significant

Array = NDArray[np.float64]
EXACT = 1e-15  # resolution of a time in double precision


@dataclass(frozen=True)
class Series:
    """Quantities at the same increasing instants."""

    file: str
    time: Array  # (n,)
    columns: Mapping[Key, Array]  # (n,)
    resolution: float = EXACT  # of a time, as a fraction of it
    digits: float | None = None  # of a value, where it is not that of the format
    notes: tuple[str, ...] = ()  # of restarts and of states that were left out
    solver: str = ""  # that wrote the file, if it says so
    offered: tuple[str, ...] = ()  # names of what else is in it, where a wrong name would be guessed


class Recorder:
    """Series that grow state by state; a state counts when it is complete.

    The first state says which of the wanted quantities there are; each later one must have them. Where time goes back,
    a restart has begun: the later run replaces the states from there on.
    """

    def __init__(self, file: str, keys: Collection[Key]) -> None:
        self.file, self.keys = file, frozenset(keys)
        self.t: float | None = None  # of the state that is being read
        self.row: dict[Key, float] = {}
        self.time = array("d")
        self.columns: dict[Key, array[float]] = {}
        self.notes: list[str] = []
        self.repeated = 0
        self.resolution, self.digits = EXACT, 17

    def state(self, t: float, place: str, digits: int = 17) -> None:
        """Begin the state at time t, known to so many digits, which ends the one before."""
        self._finish(place)
        self.t, self.row = t, {}
        if t and digits < self.digits:
            self.digits, self.resolution = digits, 10.0 ** (1 - digits)

    def begin(self, text: str, lines: Lines) -> None:
        """Begin the state whose time is written by `text`, in the current line."""
        self.state(lines.time_of(text), lines.place, significant(text))

    def put(self, key: Key, value: float) -> None:
        """A value of the current state, if it is wanted."""
        if key in self.keys:
            self.row[key] = value

    def add(self, key: Key, value: float) -> None:
        """A part of a value of the current state, if it is wanted."""
        if key in self.keys:
            self.row[key] = self.row.get(key, 0.0) + value

    def has(self, key: Key) -> bool:
        """Whether the current state has this quantity already: the file then goes on with another state."""
        return key in self.row

    def _finish(self, place: str) -> None:
        if self.t is None:
            return
        missing = self.columns.keys() - self.row.keys()
        if missing:
            raise ResultError(f"{place}: the state at t = {self.t:g} ends without {min(missing)}")
        if not self.time:
            self.columns = {key: array("d") for key in self.row}
        elif self.t <= self.time[-1]:
            self._go_back(self.t, place)
        self.time.append(self.t)
        for key, column in self.columns.items():
            column.append(self.row[key])

    def _go_back(self, t: float, place: str) -> None:
        first = bisect_left(self.time, t)
        if t == self.time[-1]:
            self.repeated += 1
        else:
            count = len(self.time) - first
            self.notes.append(
                f"{place}: time goes back from {self.time[-1]:g} to {t:g}: a restart, which replaces {count} states"
            )
        del self.time[first:]
        for column in self.columns.values():
            del column[first:]

    def series(self, place: str, cut: bool = False, solver: str = "", expected: str = "") -> Series:
        """All complete states; `cut`: the file ends within the last one.

        Raises ResultError if there is none: `expected` says what was looked for.
        """
        if self.t is not None and (cut or self.columns.keys() - self.row.keys()):
            self.notes.append(f"{place}: the file ends within the state at t = {self.t:g}, which is left out")
        else:
            self._finish(place)
        if not self.time:
            raise ResultError(f"{self.file}: no complete state; expected {expected}")
        if self.repeated:
            self.notes.append(
                f"{self.file}: {self.repeated} states have the printed time of the state before, and replace it"
            )
        columns = {key: np.array(column) for key, column in self.columns.items()}
        return Series(
            self.file, np.array(self.time), columns, self.resolution, notes=tuple(self.notes), solver=solver
        )


def recorded(recorder: Recorder, lines: Lines, expected: str) -> list[Series]:
    """What was recorded from the lines of a file."""
    series = recorder.series(lines.place, lines.cut, lines.solver, expected)
    return [replace(series, digits=float(lines.digits) or None)]


def join(parts: Collection[Series], keys: Collection[Key]) -> Series:
    """The `keys` of several files as one series: a file that begins later replaces what lies after its beginning."""
    first, *others = sorted(parts, key=lambda part: part.time[0])
    whole = replace(first, columns={key: first.columns[key] for key in keys})
    for part in others:
        kept = whole.time < part.time[0]
        columns = {key: np.concatenate([whole.columns[key][kept], part.columns[key]]) for key in keys}
        whole = replace(
            whole,
            file=f"{whole.file}, {part.file}",
            time=np.concatenate([whole.time[kept], part.time]),
            columns=columns,
            resolution=max(whole.resolution, part.resolution),
            digits=min(filter(None, (whole.digits, part.digits)), default=None),
            notes=(*whole.notes, *part.notes),
        )
    return whole
