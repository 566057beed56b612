"""Which planted faults the results of a case notice: its score, and that of the manual."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

from vmharness.round_off import largest
from vmharness.studies.maker import Maker


class Noticed(StrEnum):
    """What became of a planted fault."""

    CAUGHT = "caught"  # the gate fails
    MISSED = "missed"  # the run differs, and passes
    UNSEEN = "not applicable"  # the run is the same to the last bit: the deck has nothing of what is wrong
    HARMLESS = (
        "harmless"  # a number of the model, not of the problem, that no result depends on, however wrong
    )
    UNJUDGED = "could not be judged"  # the run was ended from outside


@dataclass(frozen=True)
class Finding:
    """A fault in one case."""

    fault: str  # its name
    text: str  # what is wrong, in words
    kind: str  # deck, physics, integration, or reading
    noticed: Noticed
    by: str = ""  # key of the result that is farthest off, where one is
    share: float | None = None  # of its tolerance
    reason: str = ""  # why there was no such result: refused, diverged


@dataclass(frozen=True)
class FaultsRecord:
    """All that was planted in one case."""

    case: str
    case_sha256: str  # of its inputs
    findings: list[Finding] = field(default_factory=list)
    made_by: Maker | None = None  # None in records of before it was kept

    @property
    def caught(self) -> int:
        """How many faults the gate noticed."""
        return sum(finding.noticed is Noticed.CAUGHT for finding in self.findings)

    @property
    def applicable(self) -> int:
        """How many faults changed anything that matters."""
        return self.caught + len(self.missed)

    @property
    def unjudged(self) -> list[Finding]:
        """What must be run again."""
        return [finding for finding in self.findings if finding.noticed is Noticed.UNJUDGED]

    @property
    def missed(self) -> list[Finding]:
        """What changed the run, and passed."""
        return [finding for finding in self.findings if finding.noticed is Noticed.MISSED]


@dataclass(frozen=True)
class Coverage:
    """What all the cases together notice of the faults of the solver, which they share."""

    matrix: dict[str, dict[str, Finding]]  # by name of the fault, then by case
    missed: list[Finding]  # seen by some case, caught by none: for each the nearest to being caught
    unseen: list[Finding]  # of what no case has anything

    @property
    def caught(self) -> int:
        """How many faults at least one case catches."""
        return len(self.matrix) - len(self.missed) - len(self.unseen)


def coverage(detections: Sequence[FaultsRecord]) -> Coverage:
    """The matrix of the solver's faults over the cases, and what no case catches: the manual's to-do list."""
    matrix: dict[str, dict[str, Finding]] = {}
    for detection in detections:
        for finding in detection.findings:
            if finding.kind != "deck" and finding.noticed is not Noticed.UNJUDGED:
                matrix.setdefault(finding.fault, {})[detection.case] = finding
    missed, unseen = [], []
    for cases in matrix.values():
        states = {finding.noticed for finding in cases.values()}
        if states == {Noticed.UNSEEN}:
            unseen.append(_nearest(cases))
        elif Noticed.CAUGHT not in states:
            missed.append(_nearest(cases))
    return Coverage(matrix, missed, unseen)


def _nearest(cases: Mapping[str, Finding]) -> Finding:
    return largest(cases.values(), lambda finding: finding.share or 0.0)
