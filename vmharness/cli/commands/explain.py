"""`vm explain`: the causes of the error of each result."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.gathering import gathered, write_record
from vmharness.cli.options import How, studying
from vmharness.cli.say import complain, say, say_rows
from vmharness.cli.selection import CASES, one
from vmharness.suite.outcome import EXIT_CODES, Status

if TYPE_CHECKING:
    from vmharness.case import Case
    from vmharness.studies.explain.record import Column


@click.command("explain")
@click.argument("selector", metavar="ID")
@CASES
@studying
def command(selector: str, cases: Path | None, how: How, out: Path, json: Path | None) -> int:
    """Split the error of each result into its causes.

    The causes are time step, sampling, rounding of the deck, contact penalty and mesh; the rest is unexplained.
    For each published column, the command finds the way of reading output states that reproduces the
    published digits.

    ID is an id, or the path of a case folder.
    """
    from vmharness.case import CaseError
    from vmharness.report.sections.explain import remarks, tables
    from vmharness.studies.explain.runs import record, variants

    try:
        case = one(selector, cases, how.timeout)
        runs = variants(case)
        outcomes = gathered(list(runs.values()), how, f"explain {case.id}")
        found = record(case, dict(zip(runs, outcomes, strict=True)))
    except CaseError as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    found = replace(found, columns=_columns(case, how))
    for table in tables(found):
        say_rows(table)
    for column in found.columns:
        if column.reading:
            say(f"{column.name}: {column.reading}: {len(column.same)} of {len(column.results)} figures")
        for key, reading in column.others.items():
            say(f"  {key}: {reading}")
    for sentence in remarks(found):
        say(sentence)
    write_record(out, case.id, "explain", found, json)
    return EXIT_CODES[Status.PASS]


def _columns(case: "Case", how: How) -> "list[Column]":
    """The published columns explained, if there are any; one more run gives the whole history."""
    from vmharness.execution.message import Done
    from vmharness.execution.pool import Pool
    from vmharness.studies.explain.published import columns
    from vmharness.suite.judge import solving

    if not case.published:
        return []
    with Pool(1, solving, how.solver) as pool:
        (*_, (_, end)) = pool.each([(case, None)], how.timeout)
    if isinstance(end, Done) and end.value.history is not None:
        return columns(case, end.value.history)
    return []
