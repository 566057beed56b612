"""Content of the index: all cases of a run, failures first."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from vmharness.compare import Verdict
from vmharness.report.blocks import Section
from vmharness.report.page import worst_row
from vmharness.report.solver import short_name
from vmharness.result import CaseRun, Row, Unrun
from vmharness.round_off import ordered

ORDER = {Verdict.ERROR: 0, Verdict.FAIL: 1, Verdict.PASS: 2, Verdict.UNREPRESENTABLE: 3}


@dataclass(frozen=True)
class Line:
    """A case in the index."""

    run: CaseRun
    worst: Row | None
    passed: int  # how many of its results
    studies: Sequence[str] = ()  # what studies found, in a few words each


@dataclass(frozen=True)
class Index:
    """The content of the index, for every format."""

    unrun: Sequence[Unrun]  # cases that nothing can be said of but why
    solvers: Mapping[
        str, list[Line]
    ]  # by solver, without its version: errors, failures, then the thinnest margin
    coverage: Mapping[str, list[CaseRun]]  # by tag
    counts: Mapping[Verdict, int]  # a case without a run is an error
    detection: Section | None = None  # what all cases together notice of planted faults
    pages: Collection[str] = ()  # of the cases without a run, those that have a page


def index(
    runs: Sequence[CaseRun],
    unrun: Sequence[Unrun],
    studies: Mapping[str, Sequence[str]],
    detection: Section | None = None,
    pages: Collection[str] = (),
) -> Index:
    """The index of `runs` and of cases without a run, which come first; `studies` are findings by case."""
    solvers: dict[str, list[Line]] = {}
    coverage: dict[str, list[CaseRun]] = {}
    for run in _worst_first(runs):
        passed = sum(row.verdict is Verdict.PASS for row in run.rows)
        # The margin of what was judged says nothing about a run that was not.
        worst = None if run.verdict is Verdict.ERROR else worst_row(run)
        solvers.setdefault(short_name(run.solution.solver), []).append(
            Line(run, worst, passed, studies.get(run.case.id, ()))
        )
    for run in sorted(runs, key=lambda run: run.case.id):
        for tag in run.case.file.tags:
            coverage.setdefault(tag, []).append(run)
    counts = {verdict: sum(run.verdict is verdict for run in runs) for verdict in Verdict}
    counts[Verdict.ERROR] += len(unrun)
    unrun = sorted(unrun, key=lambda case: case.id)
    return Index(unrun, solvers, dict(sorted(coverage.items())), counts, detection, pages)


def _worst_first(runs: Sequence[CaseRun]) -> list[CaseRun]:
    """Sort key: verdict, then largest share of a tolerance, then id."""
    by_id = sorted(runs, key=lambda run: run.case.id)
    by_share = ordered(by_id, lambda run: -(row.used or 0.0) if (row := worst_row(run)) else 0.0)
    return sorted(by_share, key=lambda run: ORDER[run.verdict])
