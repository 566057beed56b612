"""Faults: what a case's results noticed of all that was planted."""

import contextlib
import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec

from vmharness.case import Case
from vmharness.report.blocks import Section, Table
from vmharness.report.number import DASH, short
from vmharness.report.records import FOLDER
from vmharness.round_off import ordered
from vmharness.studies.faults.record import Coverage, FaultsRecord, Finding, Noticed, coverage

FILE = "faults.json"
SHOWN = 5  # cases that a row names
HEADS = {"of the other sign": "other sign", "1000 times as large": "1000 ×"}
KINDS = {
    "deck": "in the deck",
    "physics": "in the solver's physics",
    "integration": "in its integration in time",
    "reading": "in what is shown or read of it",
}


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm faults`."""
    found = msgspec.json.decode(content, type=FaultsRecord)
    text = [
        f"Of {found.applicable} planted faults that change this run, {found.caught} are caught: a result leaves its "
        "tolerance, or the solver refuses to go on. Numbers are the largest distance from a target, in tolerances."
    ]
    if found.missed:
        text.append(f"Not noticed here: {', '.join(finding.fault for finding in found.missed)}.")
    tables = [table for table in (_parameters(found), _others(found)) if table.rows]
    return Section("Faults", score(found), text, tables, remarks=_unseen(found))


def score(found: FaultsRecord) -> str:
    """How many of the faults that change anything are caught."""
    return f"{found.caught} of {found.applicable} faults"


def cell(finding: Finding | None) -> str:
    """What became of a fault, in a word and a number.

    >>> cell(Finding("a", "A", "deck", Noticed.MISSED, "z", 0.34)), cell(None)
    ('✗ 0.34 ×', '–')
    """
    if finding is None or finding.noticed in (Noticed.UNSEEN, Noticed.HARMLESS, Noticed.UNJUDGED):
        return DASH
    sign = "✓" if finding.noticed is Noticed.CAUGHT else "✗"
    return f"{sign} {times(finding.share)}"


def times(share: float | None) -> str:
    """A distance from a target in tolerances, to two digits.

    >>> times(0.344), times(7.19), times(23.8e6), times(None)
    ('0.34 ×', '7.2 ×', '2.4e7 ×', 'no result')
    """
    return "no result" if share is None else f"{short(float(f'{share:.2g}'))} ×"


def manual(cases: Sequence[Case], root: Path) -> Section | None:
    """What all cases studied notice of the faults of the solver: the matrix, and what none of them catches.

    None where no record of `vm faults` lies beside the pages below `root`.
    """
    paths = [root / case.id / FOLDER / FILE for case in sorted(cases, key=lambda case: case.id)]
    detections = []
    for path in paths:
        with contextlib.suppress(OSError, msgspec.MsgspecError):
            detections.append(msgspec.json.decode(path.read_bytes(), type=FaultsRecord))
    return together(detections) if detections else None


def together(detections: Sequence[FaultsRecord]) -> Section:
    """The section of the index."""
    found = coverage(detections)
    text = [
        f"Faults are planted in the solver, one at a time. Of {len(found.matrix)}, {found.caught} are caught by a "
        "case: a result leaves its tolerance, or there is none, for the solver refuses to go on or an event never "
        "comes. The case that sees it farthest off is named first."
    ]
    head = ["Fault", "Caught by", "Farthest off, in tolerances", "Changes without notice"]
    rows = [_together(cases) for cases in found.matrix.values()]
    return Section(
        "What the cases notice",
        f"{found.caught} of {len(found.matrix)}",
        text,
        [Table(head, rows, numbers=len(head))],
        remarks=to_do(found),
    )


def _together(cases: Mapping[str, Finding]) -> list[str]:
    """What became of one fault in all cases."""
    shares = {case: math.inf if finding.share is None else finding.share for case, finding in cases.items()}
    far = ordered(shares, lambda case: -shares[case])
    caught = [case for case in far if cases[case].noticed is Noticed.CAUGHT]
    missed = [case for case in far if cases[case].noticed is Noticed.MISSED]
    largest = times(cases[caught[0]].share) if caught else DASH
    return [next(iter(cases.values())).text, _some(caught), largest, _some(missed)]


def _some(cases: Sequence[str]) -> str:
    """The first few of many.

    >>> _some(["D-22", "D-23"]), _some(["A", "B", "C", "D", "E", "F", "G"]), _some([])
    ('D-22, D-23', 'A, B, C, D and 3 more', '–')
    """
    if len(cases) <= SHOWN:
        return ", ".join(cases) or DASH
    return f"{', '.join(cases[: SHOWN - 1])} and {len(cases) - SHOWN + 1} more"


def to_do(found: Coverage) -> list[str]:
    """The faults that no case catches, and those of which no case has anything."""
    said = [
        f"No case catches {finding.fault} ({finding.text}); nearest is {finding.by}, "
        f"at {times(finding.share)} its tolerance."
        for finding in found.missed
    ]
    unseen = [finding.fault for finding in found.unseen]
    return said + ([f"No case has anything of {', '.join(unseen)}."] if unseen else [])


def _parameters(found: FaultsRecord) -> Table:
    """Deck faults of one parameter: a row a parameter, a column a change."""
    changes: dict[str, dict[str, Finding]] = {}
    for finding in found.findings:
        name, _, how = finding.fault.partition(" ")
        if finding.kind == "deck" and not finding.fault.endswith("missing"):
            changes.setdefault(name, {})[how] = finding
    columns = list(next(iter(changes.values()), {}))
    rows = [[name, *(cell(row.get(how)) for how in columns)] for name, row in changes.items()]
    heads = [HEADS.get(how, how) for how in columns]
    return Table(["In the deck", *heads], rows)


def _others(found: FaultsRecord) -> Table:
    shown = {row[0] for row in _parameters(found).rows}
    rows = [
        [finding.text, KINDS[finding.kind], cell(finding), finding.by or finding.reason or DASH]
        for finding in found.findings
        if finding.noticed not in (Noticed.UNSEEN, Noticed.UNJUDGED)
        and finding.fault.partition(" ")[0] not in shown
    ]
    return Table(["Fault", "Where", "Caught?", "By"], rows, numbers=4)


def _unseen(found: FaultsRecord) -> list[str]:
    """Faults of which the case has nothing, and parameters that no result depends on."""
    unseen = [finding.fault for finding in found.findings if finding.noticed is Noticed.UNSEEN]
    idle = [
        finding.fault.partition(" ")[0] for finding in found.findings if finding.noticed is Noticed.HARMLESS
    ]
    said = [f"Not applicable, for the run is the same with it: {', '.join(unseen)}."] if unseen else []
    said += [f"Could not be judged: {finding.fault} ({finding.reason})." for finding in found.unjudged]
    harmless = ", ".join(dict.fromkeys(idle))
    return said + (
        [f"Of the model, and without effect on any result, however wrong: {harmless}."] if idle else []
    )
