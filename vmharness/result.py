"""What a run of a case gives: all that a report or a gate needs, and nothing of the solver."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vmharness.case import Case
from vmharness.compare import Comparison, Verdict, worst
from vmharness.events import Event
from vmharness.history import History
from vmharness.mesh.view import View
from vmharness.round_off import ROUND_OFF

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Published:
    """A value printed elsewhere for a result: its digits, and the error that stands beside it, if any."""

    text: str
    error_percent: float | None


@dataclass(frozen=True)
class Row:
    """A row of the manual's table; target, value and allowed difference are in `unit`."""

    key: str
    label: str
    event: str  # title of the event, by which rows are grouped
    unit: str
    comparison: Comparison
    uncertainty: (
        float | None
    )  # how far sampling leaves the time of the event open, in consistent units of time
    because: str  # why the tolerance is what it is
    budget: float | None  # sum of the error budget, as a fraction of the target
    published: Mapping[str, Published]  # by name of the column

    @property
    def verdict(self) -> Verdict:
        """Pass, fail, or error."""
        return self.comparison.verdict

    @property
    def used(self) -> float | None:
        """The share of the tolerance that it uses; none of it where the distance from the target is round-off."""
        c = self.comparison
        return (
            0.0 if c.share is not None and abs(c.value - c.target) <= ROUND_OFF * abs(c.target) else c.share
        )


@dataclass(frozen=True)
class Reading:
    """A published value beside our history read as that column seems to have been read."""

    key: str
    label: str
    unit: str
    published: str
    read: float  # at the state that the reading picks
    at: float  # the time of that state
    same: bool  # it prints as the published digits
    target: float
    other: tuple[float, float] | None = None  # time and value of another reading that the case proposes
    other_same: bool = False


@dataclass(frozen=True)
class Source:
    """Where a channel was read from, and how well it is known there: what a tolerance for it must allow."""

    file: str
    format: str
    interval: float  # the longest between two samples, in consistent units
    digits: float  # significant decimal digits of a value
    scheme: str  # at which instants the values of a cycle hold


@dataclass(frozen=True)
class Solution:
    """What a solver makes of a deck."""

    solver: str  # name and version
    history: History | None
    failure: str = ""  # why the run ended before its end, or did not begin
    unrepresentable: str = ""  # why the solver cannot pose the problem, which is no failure of it
    lost: bool = False  # the solver is missing, or its program failed: that says nothing of the deck
    facts: Mapping[str, str] = field(default_factory=dict)  # for the provenance: time step, cycles, ...
    cycles: int = 0
    seconds: float = 0.0
    seconds_loop: float = 0.0
    notes: tuple[str, ...] = ()  # what was read without effect
    files: Mapping[str, str] = field(default_factory=dict)  # sha256 by name: the deck and what it includes
    view: View | None = None
    resolved_deck: str = ""  # the deck that ran, where it is not that of the case's folder
    unreported: Mapping[str, str] = field(default_factory=dict)  # channels that it does not give, and why
    sources: Mapping[str, Source] = field(default_factory=dict)  # where channels were read from, by name
    unfinished: str = ""  # why an event that did not happen may have come later


@dataclass(frozen=True)
class Unrun:
    """A selected case that has no run: it could not be read, hit a defect, or was not reached."""

    id: str
    reason: str


@dataclass(frozen=True)
class CaseRun:
    """One case through one solver, judged."""

    case: Case
    solution: Solution
    rows: tuple[Row, ...]
    events: Mapping[str, Event | str]  # when each happened, or why that could not be found
    readings: Mapping[str, tuple[Reading, ...]]  # by name of the published column
    deck_sha256: str  # of the deck that ran
    case_sha256: str
    seconds: float

    @property
    def verdict(self) -> Verdict:
        """The worst of the rows; an error where the solver did not finish."""
        if self.solution.failure:
            return Verdict.ERROR
        return worst([row.verdict for row in self.rows])

    @property
    def included(self) -> dict[str, str]:
        """SHA-256 of every file that the deck includes, by its name relative to the deck's folder."""
        return {name: sha for name, sha in self.solution.files.items() if name != self.case.deck_name}

    @property
    def groups(self) -> list[tuple[str, list[Row]]]:
        """The rows by the title of their event, in the order in which the events first come."""
        found: dict[str, list[Row]] = {}
        for row in self.rows:
            found.setdefault(row.event, []).append(row)
        return list(found.items())

    @property
    def reason(self) -> str:
        """Why the case did not pass: the first thing to look at."""
        if self.solution.failure or self.solution.unrepresentable:
            return self.solution.failure or self.solution.unrepresentable
        wrong = [row for row in self.rows if row.verdict is self.verdict and row.comparison.reason]
        if not wrong and self.verdict is Verdict.ERROR:
            wrong = [row for row in self.rows if row.comparison.reason]
        return f"{wrong[0].key}: {wrong[0].comparison.reason}" if wrong else ""

    @property
    def unreported(self) -> list[Row]:
        """The rows of which the results do not hold the quantity."""
        return [row for row in self.rows if row.verdict is Verdict.UNREPORTED]
