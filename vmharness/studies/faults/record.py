"""Record of planted faults: which of them the results of a case catch, and which the whole manual catches."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

from vmharness.round_off import largest
from vmharness.studies.maker import Maker


class Noticed(StrEnum):
    """The effect of a planted fault."""

    CAUGHT = "caught"  # a result fails, or the run ends early
    MISSED = "missed"  # the run changes, and passes
    UNSEEN = "not applicable"  # the run is the same to the last bit: the deck does not use what is wrong
    HARMLESS = "harmless"  # a wrong number of the model, not of the problem, that makes no result fail
    UNJUDGED = "could not be judged"  # the run was ended from outside


@dataclass(frozen=True)
class Finding:
    """A fault in one case."""

    fault: str  # its name
    text: str  # what is wrong, in words
    kind: str  # deck, physics, integration, or reading
    noticed: Noticed
    by: str = ""  # key of the result with the largest error in tolerances, if there is one
    share: float | None = None  # of its tolerance
    reason: str = ""  # why there is no such result: the deck was refused, the run diverged


@dataclass(frozen=True)
class FaultsRecord:
    """The record of `vm faults` for one case."""

    case: str
    case_sha256: str  # of its inputs
    findings: list[Finding] = field(default_factory=list)
    made_by: Maker | None = None  # None in records of before it was kept
    unmoved: list[str] = field(default_factory=list)  # keys of results that no fault changes
    unproven: list[str] = field(default_factory=list)  # declared faults that do not fail what they must

    @property
    def caught(self) -> int:
        """How many faults are caught."""
        return sum(finding.noticed is Noticed.CAUGHT for finding in self.findings)

    @property
    def applicable(self) -> int:
        """How many faults change the run, without the harmless ones."""
        return self.caught + len(self.missed)

    @property
    def unjudged(self) -> list[Finding]:
        """What must be run again."""
        return [finding for finding in self.findings if finding.noticed is Noticed.UNJUDGED]

    @property
    def missed(self) -> list[Finding]:
        """The faults that change the run, and pass."""
        return [finding for finding in self.findings if finding.noticed is Noticed.MISSED]


@dataclass(frozen=True)
class Coverage:
    """The faults of the solver over all cases."""

    matrix: dict[str, dict[str, Finding]]  # by name of the fault, then by case
    missed: list[Finding]  # faults that change a case, but fail none: the finding with the largest error
    unseen: list[Finding]  # faults that change no case

    @property
    def caught(self) -> int:
        """How many faults at least one case catches."""
        return len(self.matrix) - len(self.missed) - len(self.unseen)


def coverage(detections: Sequence[FaultsRecord]) -> Coverage:
    """The faults of the solver over the cases, and the faults that no case catches."""
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
