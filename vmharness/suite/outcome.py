"""Outcome of a selected case, and the exit code of all outcomes."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from vmharness.compare import Verdict
from vmharness.round_off import ordered

if TYPE_CHECKING:
    from vmharness.result import CaseRun


class Status(StrEnum):
    """Status of a case, the worst first."""

    NOT_RUN = "not run"  # interrupted before it was done
    DEFECT = "defect"  # of the harness
    BROKEN = "case error"
    UNWRITTEN = "not written"  # of a file, never of a case
    UNJUDGED = "error"  # the solver is missing, crashed, or ran out of time
    FAIL = "fail"
    UNREPRESENTABLE = "not representable"  # the solver cannot pose the problem
    PASS = "pass"


EXIT_CODES = {
    Status.NOT_RUN: 2,
    Status.DEFECT: 3,
    Status.BROKEN: 4,
    Status.UNWRITTEN: 4,
    Status.UNJUDGED: 6,
    Status.UNREPRESENTABLE: 6,
    Status.FAIL: 1,
    Status.PASS: 0,
}
NOTHING_SELECTED = 5


@dataclass(frozen=True)
class Unwritten:
    """A file that could not be written, with the reason."""

    what: str
    status: Status
    reason: str
    traceback: str = ""  # of a defect


@dataclass(frozen=True)
class Outcome:
    """The outcome of a selected case, with the reason."""

    id: str
    status: Status
    reason: str = ""
    run: "CaseRun | None" = None
    traceback: str = ""  # of a defect
    started: str = ""  # when the solver began: UTC, as 2026-01-31T09:30:00Z
    seconds: float | None = None  # from then to the verdict

    @property
    def share(self) -> float | None:
        """The largest share of its tolerance that a result uses; None without one."""
        rows = self.run.rows if self.run else ()
        shares = [row.comparison.share for row in rows if row.verdict is not Verdict.UNREPORTED]
        known = [share for share in shares if share is not None]
        return max(known) if known and len(known) == len(shares) else None


def exit_code(statuses: Iterable[Status]) -> int:
    """0 all pass; 1 out of tolerance; 2 interrupted; 3 defect; 4 case error; 5 nothing selected; 6 not judged.

    Of several the first of 2, 3, 4, 6, 1 is given. A case that the solver cannot represent counts only where there is
    no other: nothing was judged.

    >>> exit_code([Status.PASS, Status.FAIL, Status.UNJUDGED])
    6
    >>> exit_code([Status.PASS, Status.UNREPRESENTABLE]), exit_code([Status.UNREPRESENTABLE])
    (0, 6)
    """
    found = set(statuses)
    if len(found) > 1:
        found.discard(Status.UNREPRESENTABLE)
    return next((EXIT_CODES[status] for status in Status if status in found), NOTHING_SELECTED)


def worst_first(outcomes: Iterable[Outcome]) -> list[Outcome]:
    """Sort outcomes by status, then by share of tolerance, then by id."""
    by_id = sorted(outcomes, key=lambda outcome: outcome.id)
    by_share = ordered(by_id, lambda outcome: -(outcome.share or 0.0))
    return sorted(by_share, key=lambda outcome: list(Status).index(outcome.status))
