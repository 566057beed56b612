"""Runs made without a solver: theory itself as the history, and results a known distance from their targets."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from vmharness.case import read
from vmharness.compare import Tolerance, compare
from vmharness.events import Event
from vmharness.formula import Unit
from vmharness.history import History
from vmharness.mesh.discrete import NONE
from vmharness.mesh.view import View
from vmharness.result import CaseRun, Published, Reading, Row, Solution

CASE = Path(__file__).parents[2] / "cases" / "VM-061"


def row(case, key, difference):
    """A result that lies `difference` tolerances from its target."""
    result = case.result(key)
    target = case.target(key) / case.units.factor(Unit(result.unit))
    tolerance = Tolerance(result.tolerance.relative, result.tolerance.absolute)
    return Row(
        key=key,
        label=result.label,
        event=case.file.events[result.event].title,
        unit=result.unit,
        comparison=compare(target, target + difference * tolerance.allowed(target), tolerance),
        uncertainty=1e-9,
        because=result.tolerance.because,
        budget=None,
        published={
            column.name: Published(column.values[key], column.errors_percent.get(key))
            for column in case.file.published
            if key in column.values
        },
    )


def theory_as_history(case, end=0.11):
    time = np.linspace(0.0, end, 1101)
    channels = {name: np.zeros_like(time) for name in case.file.channels}
    channels |= {name: case.curve(name, time) for name in case.file.curves}
    return History(time, channels)


def view():
    x = np.array([[-0.2, -0.2, 0], [0.2, -0.2, 0], [0.2, 0.2, 0], [-0.2, 0.2, 0], [0, 0, 1.0]])
    corners = np.arange(4)
    return View(
        ids=np.arange(1, 6),
        x=x,
        shells=corners[None, :],
        solids=np.zeros((0, 8), np.intp),
        beams=np.zeros((0, 2), np.intp),
        discrete=NONE,
        masses=np.array([4]),
        supports=corners,
        gravity=np.array([0.0, 0.0, -386.0]),
        contacts=((np.array([4]), corners[None, :]),),
    )


def reading(case, key, read, same, other=None):
    return Reading(
        key=key,
        label=case.result(key).label,
        unit=case.result(key).unit,
        published=case.file.published[0].values[key],
        read=read,
        at=0.0719985,
        same=same,
        target=case.target(key),
        other=other,
        other_same=other is not None,
    )


@pytest.fixture
def result_row():
    """`row`, for runs that a test makes itself."""
    return row


@pytest.fixture(scope="session")
def case():
    return read(CASE)


@pytest.fixture
def good(case):
    """A run that passes: each result half its tolerance from its target."""
    return run_of(case)


@pytest.fixture(scope="session")
def make_run():
    """`run_of`, for cases that a test makes itself."""
    return run_of


def run_of(case):
    """A run of the case VM-061, or of one with other texts: each result half its tolerance from its target."""
    column = case.file.published[0].name
    solution = Solution(
        solver="vmharness 9.9.9",
        history=theory_as_history(case),
        facts={"Time step": "1e-4"},
        cycles=1100,
        seconds=1.25,
        seconds_loop=1.0,
        notes=("*TITLE: a name",),
        view=view(),
    )
    return CaseRun(
        case=case,
        solution=solution,
        rows=tuple(row(case, result.key, 0.5) for result in case.file.results),
        events={
            "impact": Event(case.theory["t_impact"], 1e-9),
            "peak": Event(case.theory["t_peak"], 1e-9),
        },
        readings={
            column: (
                reading(case, "z_impact", -1.000467, True),
                reading(case, "ke_impact", 193.0901, False, (0.072, 193.0986)),
            )
        },
        deck_sha256="d" * 64,
        case_sha256="c" * 64,
        seconds=1.5,
    )


@pytest.fixture
def failed(good):
    """A run with one result three tolerances away."""
    rows = tuple(row(good.case, r.key, 3.0) if r.key == "z_peak" else r for r in good.rows)
    return replace(good, rows=rows)


@pytest.fixture
def broken(good):
    """A run that ended before the second event."""
    why = "At Maximum Displacement: never happened"
    nothing = compare(-1.0, float("nan"), Tolerance(relative=1e-5))
    rows = tuple(replace(r, comparison=nothing) if "peak" in r.key else r for r in good.rows)
    solution = replace(
        good.solution,
        failure="energy is not finite at t = 0.08 <cycle 800>",
        history=theory_as_history(good.case, 0.08),
    )
    return replace(good, solution=solution, rows=rows, events={**good.events, "peak": why}, readings={})
