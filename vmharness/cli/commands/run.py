"""`vm run`: solve cases, compare them with theory, write the pages."""

import time
from collections.abc import Sequence
from pathlib import Path

import click

from vmharness.cli import options
from vmharness.cli.rerun import rerun_commands
from vmharness.cli.say import complain, say
from vmharness.cli.selection import selected, selecting
from vmharness.cli.summary import summarise
from vmharness.suite import last_run
from vmharness.suite.outcome import NOTHING_SELECTED, Outcome, Status, exit_code
from vmharness.suite.timed import Began, now

REPORTS, RUNS = Path("reports"), Path("runs")
SHOWN = 5  # pages of a run of several cases whose paths are printed


@click.command("run")
@selecting
@options.running
@click.option(
    "--lf", is_flag=True, help="Only cases that did not pass, or were not reached, in the last run."
)
@click.option("--out", type=options.FOLDER, metavar="DIR", help="Folder for the reports.  [default: reports]")
@click.option("--no-report", is_flag=True, help="Write no reports.")
@options.formats
@click.pass_context
def command(
    ctx: click.Context,
    selectors: tuple[str, ...],
    cases: Path | None,
    words: str,
    tags: tuple[str, ...],
    jobs: int,
    solver: str,
    data: dict[str, float],
    timeout: float,
    lf: bool,
    out: Path | None,
    no_report: bool,
) -> int:
    """Run cases, compare with theory, write the manual.

    A case passes if every result lies within its tolerance.

    SELECT is an id, a pattern such as 'VM-0*', or the path of a case folder; without any, all cases are run.
    """
    from vmharness.cli.pipeline import Wanted, run_cases, write_exports, write_files  # not needed for --help

    began = Began(["vm", *ctx.find_root().obj], now(), time.perf_counter())
    found, unknown = selected(selectors, cases, words, tags)
    if lf:
        pending = last_run.not_passed(out or REPORTS)
        found = [case for case in found if case.id in pending]
    outcomes = [Outcome(selector, Status.BROKEN, problem) for selector, problem in unknown.items()]
    if not found:
        complain("nothing selected")
        for file in write_exports(outcomes, found, solver, options.files(ctx), began):
            complain(f"{file.what} cannot be written: {file.reason}")
        return NOTHING_SELECTED
    narrowed = bool(selectors or words or tags or lf or data)
    wanted = Wanted(
        solver=solver,
        data=data,
        jobs=jobs,
        timeout=timeout,
        root=out or (RUNS if data else REPORTS),
        report=not no_report,
        index=not (narrowed or no_report),
        files=options.files(ctx),
    )
    done, unwritten = run_cases(found, wanted)
    outcomes += done
    unwritten += write_files(outcomes, found, wanted, began)
    summarise(outcomes, unwritten, rerun_commands(found, ctx.params), ctx.find_root().params["debug"])
    if wanted.report:
        _say_where([wanted.name(case.id) for case in found], wanted.root, wanted.index)
        if not wanted.index and (wanted.root / "index.html").is_file():
            say("the index is from an earlier run; `vm run` without a selection writes it again")
    return exit_code([*(outcome.status for outcome in outcomes), *(file.status for file in unwritten)])


def _say_where(names: Sequence[str], root: Path, indexed: bool) -> None:
    """Print the files to open: the index if it was written, else the pages of the cases."""
    folders = [root] if indexed else [root / name for name in names[:SHOWN]]
    for page in (folder / "index.html" for folder in folders):
        if page.is_file():
            say(f"report: {page}")
    if len(names) > SHOWN and not indexed:
        say(f"and {len(names) - SHOWN} more reports: {root / '*' / 'index.html'}")
