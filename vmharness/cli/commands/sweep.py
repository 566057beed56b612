"""`vm sweep`: a case run at many points of a region of its data."""

from pathlib import Path

import click

from vmharness.cli.gathering import gathered, write_record
from vmharness.cli.options import How, studying
from vmharness.cli.rerun import rerun_commands
from vmharness.cli.say import complain, say, say_rows
from vmharness.cli.selection import CASES, one
from vmharness.suite.outcome import EXIT_CODES, Status
from vmharness.suite.select import Entry


@click.command("sweep")
@click.argument("selector", metavar="ID")
@CASES
@click.option(
    "-n", "--points", type=click.IntRange(1), metavar="N", help="Number of points of a Latin hypercube."
)
@click.option(
    "--seed",
    type=click.IntRange(0),
    default=0,
    metavar="N",
    help="Seed of the Latin hypercube.  [default: 0]",
)
@click.option(
    "--grid", type=click.IntRange(2), metavar="N", help="Use a grid with N values of each datum instead."
)
@studying
def command(
    selector: str,
    cases: Path | None,
    points: int | None,
    seed: int,
    grid: int | None,
    how: How,
    out: Path,
    json: Path | None,
) -> int:
    """Run a case at many points of a region of its data.

    The table [sweep] of the case declares the region. For a failing point, the command
    searches simpler data that also fail.

    ID is an id, or the path of a case folder.
    """
    from vmharness.case import CaseError
    from vmharness.report.sections.sweep import plan, remarks, tables, verdict
    from vmharness.studies.gather import pool
    from vmharness.studies.sweep import runs as sweep

    if points is not None and grid is not None:
        raise click.UsageError("use either --points or --grid, not both")
    try:
        case = one(selector, cases, how.timeout)
        chosen, words = sweep.points(case, points, seed, grid)
    except CaseError as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    options = {"selectors": [selector], "cases": cases, "solver": how.solver, "timeout": how.timeout}
    with pool(how.jobs, how.solver) as workers:
        found = sweep.record(
            case,
            chosen,
            words,
            lambda variants, what: gathered(variants, how, f"{case.id}: {what}", workers=workers),
            rerun_commands([Entry(case.folder)], options)[case.id],
        )
    for table in tables(found):
        say_rows(table)
    for sentence in (plan(found), verdict(found), *remarks(found)):
        say(sentence)
    write_record(out, case.id, "sweep", found, json)
    status = Status.UNJUDGED if found.unjudged else Status.FAIL if found.failed else Status.PASS
    return EXIT_CODES[status]
