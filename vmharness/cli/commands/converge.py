"""`vm converge`: the order of accuracy of a case, and its extrapolated results."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.gathering import gathered, write_record
from vmharness.cli.options import How, studying
from vmharness.cli.say import complain, say, say_rows
from vmharness.cli.selection import CASES, one
from vmharness.suite.outcome import EXIT_CODES, Status

if TYPE_CHECKING:
    from vmharness.studies.converge.record import ConvergeRecord


@click.command("converge")
@click.argument("selector", metavar="ID")
@CASES
@studying
def command(selector: str, cases: Path | None, how: How, out: Path, json: Path | None) -> int:
    """Refine time step or mesh; find the order of accuracy.

    The table [converge] of the case says what is refined. The command prints the order of accuracy, the
    extrapolated value of each result and its uncertainty (grid convergence index, GCI).

    ID is an id, or the path of a case folder.
    """
    from vmharness.case import CaseError
    from vmharness.studies.converge.runs import record, variants

    try:
        case = one(selector, cases, how.timeout)
        runs = variants(case)
    except CaseError as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    found = record(case, gathered(runs, how, f"converge {case.id}"))
    _show(found)
    write_record(out, case.id, "converge", found, json)
    if any(level.failure for level in found.levels):
        return EXIT_CODES[Status.UNJUDGED]
    wrong = [result.key for result in found.results if result.agrees is False]
    for key in wrong:
        say(f"{key}: the order is lower than theory expects")
    return EXIT_CODES[Status.FAIL if wrong else Status.PASS]


def _show(found: "ConvergeRecord") -> None:
    from vmharness.report.sections.converge import plan, remarks, tables

    for table in tables(found):
        say_rows(table)
    for remark in remarks(found):
        say(remark)
    say(plan(found))
