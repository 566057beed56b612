"""Section on planted faults: which of them the results of a case catch."""

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
HEADS = {"with the opposite sign": "opposite sign", "1000 times as large": "1000 ×"}
KINDS = {
    "deck": "deck",
    "physics": "solver: physics",
    "integration": "solver: time integration",
    "reading": "output or reading",
}


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm faults`."""
    found = msgspec.json.decode(content, type=FaultsRecord)
    text = [
        "Faults are planted in the deck and in the solver, one at a time. "
        f"Of the {found.applicable} faults that change this run, {found.caught} are caught: a result fails, or the "
        "solver stops. Each number is the largest error of a result, as a multiple of its tolerance."
    ]
    if found.missed:
        text.append(f"Not caught in this case: {', '.join(finding.fault for finding in found.missed)}.")
    if found.unmoved:
        text.append(
            f"No fault of deck or solver changes the value of {', '.join(found.unmoved)}: "
            "this cannot disagree with its target."
        )
    text += [f"Declared fault: {sentence}." for sentence in found.unproven]
    tables = [table for table in (_parameters(found), _others(found)) if table.rows]
    return Section(
        "Planted faults", score(found), text, tables, remarks=_remarks(found), folded=_unseen(found)
    )


def score(found: FaultsRecord) -> str:
    """How many of the faults that change the run are caught."""
    return f"{found.caught} of {found.applicable} faults caught"


def cell(finding: Finding | None) -> str:
    """Whether a fault is caught, and the largest error in tolerances.

    >>> cell(Finding("a", "A", "deck", Noticed.MISSED, "z", 0.34)), cell(None)
    ('✗ 0.34 ×', '–')
    """
    if finding is None or finding.noticed in (Noticed.UNSEEN, Noticed.HARMLESS, Noticed.UNJUDGED):
        return DASH
    sign = "✓" if finding.noticed is Noticed.CAUGHT else "✗"
    return f"{sign} {times(finding.share)}"


def times(share: float | None) -> str:
    """An error in tolerances, to two digits.

    >>> times(0.344), times(7.19), times(23.8e6), times(None)
    ('0.34 ×', '7.2 ×', '2.4e7 ×', 'no result')
    """
    return "no result" if share is None else f"{short(float(f'{share:.2g}'))} ×"


def manual(cases: Sequence[Case], root: Path) -> Section | None:
    """Which faults of the solver the cases catch together, and which none of them catches.

    None if no page below `root` has a record of `vm faults` with such a fault.
    """
    paths = [root / case.id / FOLDER / FILE for case in sorted(cases, key=lambda case: case.id)]
    detections = []
    for path in paths:
        with contextlib.suppress(OSError, RecursionError, msgspec.MsgspecError):
            detections.append(msgspec.json.decode(path.read_bytes(), type=FaultsRecord))
    return together(detections) if coverage(detections).matrix else None


def together(detections: Sequence[FaultsRecord]) -> Section:
    """The section of the index."""
    found = coverage(detections)
    text = [
        f"Faults are planted in the solver, one at a time. Of {len(found.matrix)} faults, {found.caught} are caught by "
        "at least one case: a result fails, the solver stops, or an event does not happen. The case with the largest "
        "error is named first."
    ]
    head = ["Fault", "Caught by", "Largest error, in tolerances", "Changed, but not caught"]
    rows = [_together(cases) for cases in found.matrix.values()]
    return Section(
        "Faults of the solver that the cases catch",
        f"{found.caught} of {len(found.matrix)}",
        text,
        [Table(head, rows, numbers=len(head))],
        remarks=to_do(found),
    )


def _together(cases: Mapping[str, Finding]) -> list[str]:
    """One fault in all cases: who catches it, and who does not."""
    shares = {case: math.inf if finding.share is None else finding.share for case, finding in cases.items()}
    far = ordered(shares, lambda case: -shares[case])
    caught = [case for case in far if cases[case].noticed is Noticed.CAUGHT]
    missed = [case for case in far if cases[case].noticed is Noticed.MISSED]
    largest = times(cases[caught[0]].share) if caught else DASH
    return [_named(next(iter(cases.values()))), _some(caught), largest, _some(missed)]


def _named(finding: Finding) -> str:
    """The text of a fault, with the name that other sentences use."""
    return finding.text if finding.kind == "deck" else f"{finding.text} ({finding.fault})"


def _some(cases: Sequence[str]) -> str:
    """The first few of many.

    >>> _some(["D-22", "D-23"]), _some(["A", "B", "C", "D", "E", "F", "G"]), _some([])
    ('D-22, D-23', 'A, B, C, D and 3 more', '–')
    """
    if len(cases) <= SHOWN:
        return ", ".join(cases) or DASH
    return f"{', '.join(cases[: SHOWN - 1])} and {len(cases) - SHOWN + 1} more"


def to_do(found: Coverage) -> list[str]:
    """The faults that no case catches, and the faults that change no case."""
    said = [
        f"No case catches {finding.fault} ({finding.text}). The largest error is that of {finding.by}: "
        f"{times(finding.share)} its tolerance."
        for finding in found.missed
    ]
    unseen = [finding.fault for finding in found.unseen]
    return said + ([f"These faults change no case: {', '.join(unseen)}."] if unseen else [])


def _parameters(found: FaultsRecord) -> Table:
    """Faults of the parameters of the deck: one row a parameter, one column a change."""
    changes: dict[str, dict[str, Finding]] = {}
    for finding in found.findings:
        name, _, how = finding.fault.partition(" ")
        if finding.kind == "deck" and not finding.fault.endswith("missing"):
            changes.setdefault(name, {})[how] = finding
    columns = list(next(iter(changes.values()), {}))
    rows = [[name, *(cell(row.get(how)) for how in columns)] for name, row in changes.items()]
    heads = [HEADS.get(how, how) for how in columns]
    return Table(["Parameter of the deck", *heads], rows)


def _others(found: FaultsRecord) -> Table:
    shown = {row[0] for row in _parameters(found).rows}
    rows = [
        [_named(finding), KINDS[finding.kind], cell(finding), finding.by or finding.reason or DASH]
        for finding in found.findings
        if finding.noticed not in (Noticed.UNSEEN, Noticed.UNJUDGED)
        and finding.fault.partition(" ")[0] not in shown
    ]
    return Table(["Fault", "Place", "Caught?", "Result, or reason"], rows, numbers=2, words=1)


def _unseen(found: FaultsRecord) -> list[tuple[str, str]]:
    """The number of faults that do not change the run, and their names."""
    unseen = [finding.fault for finding in found.findings if finding.noticed is Noticed.UNSEEN]
    if not unseen:
        return []
    return [(f"{_count(len(unseen))} change this run.", f"{', '.join(unseen)}.")]


def _count(number: int) -> str:
    """A number of faults as the subject of a negation.

    >>> _count(1), _count(35)
    ('1 planted fault does not', '35 planted faults do not')
    """
    return "1 planted fault does not" if number == 1 else f"{number} planted faults do not"


def _remarks(found: FaultsRecord) -> list[str]:
    """Faults that could not be judged, and parameters of the model whose faults make no result fail."""
    idle = [
        finding.fault.partition(" ")[0] for finding in found.findings if finding.noticed is Noticed.HARMLESS
    ]
    said = [f"Could not be judged: {finding.fault} ({finding.reason})." for finding in found.unjudged]
    harmless = ", ".join(dict.fromkeys(idle))
    return said + (
        [
            f"These parameters describe the model, not the problem. Wrong values make no result fail: {harmless}."
        ]
        if idle
        else []
    )
