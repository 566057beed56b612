"""`vm faults`: which planted faults the cases catch."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.gathering import gathered, write_record
from vmharness.cli.options import How, studying
from vmharness.cli.say import complain, plain_table, say, say_table, write_file
from vmharness.cli.selection import read_apart, selected, selecting
from vmharness.suite.outcome import EXIT_CODES, NOTHING_SELECTED, Status, exit_code

if TYPE_CHECKING:
    from vmharness.case import Case
    from vmharness.studies.faults.record import FaultsRecord


@click.command("faults")
@selecting
@studying
def command(
    selectors: tuple[str, ...],
    cases: Path | None,
    words: str,
    tags: tuple[str, ...],
    how: How,
    out: Path,
    json: Path | None,
) -> int:
    """Plant faults one by one; see which of them make a result fail.

    The faults are in the deck, in the built-in solver and in the reading of the results. With another solver, only
    faults of deck and reading are planted.

    SELECT is an id, a pattern such as 'VM-0*', or the path of a case folder; without any, all cases are studied.
    """
    found, unknown = selected(selectors, cases, words, tags)
    if not found:
        complain("nothing selected")
        return NOTHING_SELECTED
    sound, broken = read_apart(found, how.timeout)
    for outcome in broken:
        complain(outcome.reason)
    detections, unjudged = _detections(sound, how)
    for detection in detections:
        write_record(out, detection.case, "faults", detection, None)
    if json is not None:
        _write(json, detections)
    _show(detections)
    lost = [(found.case, finding) for found in detections for finding in found.unjudged]
    for case, finding in lost:
        complain(f"{case}: {finding.fault}: could not be judged: {finding.reason}; run the command again")
    blind = [f"{found.case}: {key}" for found in detections for key in found.unmoved]
    for result in blind:
        complain(
            f"{result}: no fault of deck or solver changes its value: this result cannot disagree with its target"
        )
    unproven = [f"{found.case}: {sentence}" for found in detections for sentence in found.unproven]
    for sentence in unproven:
        complain(sentence)
    statuses = [Status.UNJUDGED] * (unjudged + len(lost))
    statuses += [Status.BROKEN] * (len(broken) + len(unknown) + len(blind) + len(unproven))
    return exit_code(statuses) if statuses else EXIT_CODES[Status.PASS]


def _detections(cases: "list[Case]", how: How) -> "tuple[list[FaultsRecord], int]":
    """The record of each case, and the number of cases that do not pass without a fault."""
    from vmharness.studies.faults.plant import plant
    from vmharness.studies.faults.runs import StudyError, all_faults, record
    from vmharness.studies.variant import Variant

    sound = gathered([Variant(case) for case in cases], how, "sound runs")
    plans = []
    for case, outcome in zip(cases, sound, strict=True):
        try:
            plans.append((case, outcome, all_faults(case, outcome, how.solver)))
        except StudyError as error:
            complain(str(error))
    variants = [fault.variant for *_, faults in plans for fault in faults]
    outcomes = iter(gathered(variants, how, "planted faults", plant))
    found = [
        record(case, outcome, faults, [next(outcomes) for _ in faults], how.solver)
        for case, outcome, faults in plans
    ]
    return found, len(cases) - len(plans)


def _show(detections: "list[FaultsRecord]") -> None:
    """Print the score of each case with the faults that it misses, then the faults that no case catches."""
    from vmharness.report.sections.faults import to_do
    from vmharness.studies.faults.record import coverage

    table = plain_table("Case", "Caught", "Missed")
    for found in detections:
        missed = ", ".join(finding.fault for finding in found.missed)
        table.add_row(found.case, f"{found.caught} of {found.applicable}", missed)
    say_table(table)
    together = coverage(detections)
    kinds = {finding.kind for cases in together.matrix.values() for finding in cases.values()}
    if kinds <= {"reading"}:
        say("no fault of the solver was planted")
    if kinds:
        where = "reading" if kinds == {"reading"} else "solver"
        caught = f"{together.caught} of {len(together.matrix)}"
        say(f"faults of the {where}: {caught} are caught by at least one of these cases")
    for sentence in to_do(together):
        say(f"  {sentence}")


def _write(path: Path, detections: "list[FaultsRecord]") -> None:
    import msgspec

    from vmharness.studies.faults.record import coverage

    record = {"cases": detections, "coverage": coverage(detections)}
    write_file(path, msgspec.json.format(msgspec.json.encode(record), indent=1).decode() + "\n")
