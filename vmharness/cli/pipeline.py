"""Run the selected cases and write their reports; an error in one case does not stop the others."""

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.case import settings
from vmharness.cli import reports
from vmharness.cli.progress import case_bars
from vmharness.cli.say import complain, say
from vmharness.execution.call import Call, Caller, caller
from vmharness.execution.message import Done, Lost, Raised
from vmharness.execution.pool import Pool
from vmharness.suite import last_run
from vmharness.suite.judge import judged, solving
from vmharness.suite.outcome import Outcome, Status, Unwritten
from vmharness.suite.read import read_cases, reader
from vmharness.suite.select import Entry
from vmharness.suite.timed import Began, timed

if TYPE_CHECKING:
    from vmharness.export import Run

IMPORTS = 30.0  # seconds for the packages of a page, which are no work of a case
NOT_REACHED = "interrupted before it was finished"


@dataclass(frozen=True)
class Wanted:
    """The options of a run."""

    solver: str
    data: Mapping[str, float]  # data to set, in the units of the cases
    jobs: int
    timeout: float
    root: Path  # of the reports
    report: bool
    index: bool
    files: Mapping[str, Path]  # for machines, by format

    def name(self, id: str) -> str:
        """The name of the case in the reports; with other data it names them, to leave the page of the manual alone."""
        return settings.label(id, self.data) if self.data else id


def run_cases(found: Sequence[Entry], wanted: Wanted) -> tuple[list[Outcome], list[Unwritten]]:
    """Solve every case in a worker, judge it and write its page; an interrupt keeps the cases so far.

    Returns the outcomes, and the pages that could not be written.
    """
    unwritten: list[Unwritten] = []
    _record(wanted, [Outcome(case.id, Status.NOT_RUN, NOT_REACHED) for case in found])
    with (
        reader() as desk,  # where cases are read and judged, and pages made
        Pool(min(wanted.jobs, len(found)), solving, wanted.solver) as pool,  # gets ready meanwhile
    ):
        try:
            cases, outcomes = read_cases(desk, found, wanted.data, wanted.timeout)
        except settings.RegionError as error:
            raise click.UsageError(f"--set: {error}") from None
        _record(wanted, outcomes)
        needed = reports.NEEDED if wanted.report else reports.NEEDED[:1]
        call = caller(desk, wanted.timeout + IMPORTS, *needed)
        for broken in outcomes:
            unwritten += write_page(call, broken, wanted)
        _say_notice(wanted.solver)
        events = judged(pool, cases, wanted.solver, wanted.timeout, call)
        try:
            for outcome in case_bars(timed(events), [case.id for case in cases]):
                outcomes.append(outcome)
                _record(wanted, [outcome])
                unwritten += write_page(call, outcome, wanted)
                if len(cases) > 1:
                    say(f"{outcome.id}: {outcome.status}")
        except KeyboardInterrupt:
            complain("interrupted; finished cases are kept, and `vm run --lf` runs the rest")
            done = {outcome.id for outcome in outcomes}
            outcomes += [
                Outcome(case.id, Status.NOT_RUN, NOT_REACHED) for case in cases if case.id not in done
            ]
    return outcomes, unwritten


def _record(wanted: Wanted, outcomes: Sequence[Outcome]) -> None:
    """Keep the record for --lf, so that a killed run can be resumed; an error shows when the run has ended."""
    if not wanted.data:
        with contextlib.suppress(OSError):
            last_run.write(wanted.root, outcomes)


def write_files(
    outcomes: Sequence[Outcome], found: Sequence[Entry], wanted: Wanted, began: Began
) -> list[Unwritten]:
    """Write the index, the exports and the record for --lf; returns the files that could not be written."""
    from vmharness import report
    from vmharness.result import Unrun

    runs = [outcome.run for outcome in outcomes if outcome.run is not None]
    unrun = [Unrun(outcome.id, outcome.reason) for outcome in outcomes if outcome.run is None]
    unwritten = write_exports(outcomes, found, wanted.solver, wanted.files, began)
    tasks: dict[str, Callable[[], object]] = {}
    if wanted.index:
        tasks["the index"] = partial(report.write_index, runs, wanted.root, unrun)
    if not wanted.data:
        tasks[str(wanted.root / last_run.FILE)] = partial(last_run.write, wanted.root, outcomes)
    return [
        *unwritten,
        *(failed for what, write in tasks.items() for failed in reports.attempted(what, write)),
    ]


def write_exports(
    outcomes: Sequence[Outcome],
    found: Sequence[Entry],
    solver: str,
    files: Mapping[str, Path],
    began: Began,
) -> list[Unwritten]:
    """Write the results for machines, also where nothing was run: a file of an earlier run would say what is past.

    Returns the files that could not be written.
    """
    from vmharness.suite.export import exported

    run = cache(partial(exported, outcomes, found, solver, began))
    tasks = {str(path): partial(_export, name, run, path) for name, path in files.items()}
    return [failed for what, write in tasks.items() for failed in reports.attempted(what, write)]


def _export(name: str, run: "Callable[[], Run]", path: Path) -> None:
    """Make the results for machines, and write them in an export format."""
    reports.write_export(name, run(), path)


def write_page(call: Caller, outcome: Outcome, wanted: Wanted) -> list[Unwritten]:
    """Write the page of an outcome; else the page of an earlier run would show a verdict that no longer holds."""
    if not wanted.report:
        return []
    what, name = f"the report of {outcome.id}", wanted.name(outcome.id)
    unjudged = partial(reports.write_unjudged, name, root=wanted.root, indexed=wanted.index)
    if outcome.run is None:
        return _written(call, what, partial(unjudged, outcome.reason))
    failed = _written(call, what, partial(reports.write_page, outcome.run, wanted.root, name, wanted.index))
    for unwritten in failed:
        _written(call, what, partial(unjudged, f"the page cannot be made: {unwritten.reason}"))
    return failed


def _written(call: Caller, what: str, write: Call) -> list[Unwritten]:
    """Make the call that writes a file; returns the file that is not written if that fails, else nothing."""
    match call(partial(reports.attempted, what, write)):
        case Done(unwritten):
            found: list[Unwritten] = unwritten
            return found
        case Lost(reason):
            return [Unwritten(what, Status.UNWRITTEN, reason)]
        case Raised(error, trace):
            return [Unwritten(what, Status.DEFECT, error, trace)]


def _say_notice(solver: str) -> None:
    """What the solver has to say before a first run; one that cannot be used is each case's outcome."""
    from vmharness.backends import BackendError, calls

    with contextlib.suppress(BackendError):
        if notice := calls.solver(solver).found().notice:
            say(notice)
