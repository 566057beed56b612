"""The outcomes of a run as the types that exports write."""

import hashlib
import math
import os
import time
from collections import Counter
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

import vmharness
from vmharness import export
from vmharness.backends import BackendError, calls
from vmharness.backends.protocol import full_name
from vmharness.report import machine
from vmharness.result import CaseRun, Row
from vmharness.studies.sources import sources
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import FILE, Entry, printable
from vmharness.suite.timed import Began

ANSWERS = (Status.PASS, Status.FAIL, Status.UNREPRESENTABLE)  # that are verdicts, too


def exported(outcomes: Iterable[Outcome], found: Iterable[Entry], solver: str, began: Began) -> export.Run:
    """A run of the cases `found` by one solver; an outcome whose id is none of theirs is that of a wrong selector.

    Without a solver, results made elsewhere were judged.
    """
    entries = {entry.id: entry for entry in found}
    asked = [_solver(solver)] if solver else []
    ordered = sorted(outcomes, key=lambda outcome: outcome.id)
    return export.Run(
        schema=export.SCHEMA,
        version=vmharness.__version__,
        command=[printable(word) for word in began.command],
        started=began.started,
        seconds=time.perf_counter() - began.at,
        machine=export.Machine(
            host=machine.host(),
            system=machine.system(),
            processor=machine.processor(),
            cores=machine.cores(),
            python=machine.python(),
            packages=machine.versions(),
        ),
        solvers=asked,
        counts=dict(Counter(str(outcome.status) for outcome in ordered)),
        cases=[
            _case(outcome, entries.get(outcome.id), asked[0].version if asked else "") for outcome in ordered
        ],
    )


def _solver(name: str) -> export.Solver:
    """What there is to say of a solver; one that cannot be asked has its name alone."""
    version, compiled = name, ""
    with suppress(BackendError):
        chosen = calls.solver(name)
        found = chosen.found()
        version, compiled = full_name(chosen, found), found.machine
    return export.Solver(name=name, version=version, machine=compiled, sources_sha256=sources(name))


def _case(outcome: Outcome, entry: Entry | None, solver: str) -> export.Case:
    run, folder = outcome.run, entry.folder if entry else None
    case = run.case if run else None
    return export.Case(
        id=outcome.id,
        title=entry.title if entry else "",
        folder=_relative(folder) if folder else None,
        solver=run.solution.solver if run else solver,
        set={name: case.datum(name) for name in case.file.given if name in case.changed} if case else {},
        outcome=str(outcome.status),
        verdict=str(outcome.status if outcome.status in ANSWERS else Status.UNJUDGED),
        reason=outcome.reason,
        started=outcome.started or None,
        seconds=outcome.seconds,
        cycles=run.solution.cycles if run else None,
        facts=dict(run.solution.facts) if run else {},
        notes=list(run.solution.notes) if run else [],
        sha256=_digests(run, folder),
        inputs_sha256=_inputs(run),
        results=[_result(run, row) for row in run.rows] if run else [],
    )


def _digests(run: CaseRun | None, folder: Path | None) -> dict[str, str]:
    """SHA-256 of the files of a run; without one, of case.toml if that can be read."""
    if run is not None:
        return {FILE: run.case_sha256, run.case.deck_name: run.deck_sha256, **run.included}
    if folder is None or not (folder / FILE).is_file():
        return {}
    with suppress(OSError):
        return {FILE: hashlib.sha256((folder / FILE).read_bytes()).hexdigest()}
    return {}


def _inputs(run: CaseRun | None) -> str | None:
    with suppress(OSError):
        return run.case.inputs_sha256 if run else None
    return None


def _result(run: CaseRun, row: Row) -> export.Result:
    c = row.comparison
    return export.Result(
        key=row.key,
        label=row.label,
        event=row.event,
        channel=run.case.result(row.key).channel,
        unit=row.unit,
        target=c.target,
        value=_number(c.value),
        error=_number(c.value - c.target),
        error_percent=_number(c.error_percent),
        tolerance=c.tolerance.allowed(c.target),
        tolerance_percent=_number(c.tolerance_percent),
        share=_number(c.share),
        verdict=str(row.verdict),
        reason=c.reason,
        published={name: float(published.text) for name, published in row.published.items()},
    )


def _number(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def _relative(folder: Path) -> str:
    """The path from the current folder, if it is below that; as text, also where a name is not UTF-8."""
    here = os.path.relpath(folder)
    return printable(str(folder) if here.startswith(os.pardir) else here)
