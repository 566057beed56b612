"""`vm judge`: judge results that another solver has written; nothing is run."""

import time
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli import options
from vmharness.cli.say import complain, say
from vmharness.cli.selection import CASES
from vmharness.execution.message import Done, Lost, Raised
from vmharness.suite.outcome import NOTHING_SELECTED, Outcome, Status, exit_code
from vmharness.suite.read import read_cases, reader
from vmharness.suite.select import Entry, SelectError, cases_folder, entries, select
from vmharness.suite.timed import Began, now

if TYPE_CHECKING:
    from vmharness.case import Case
    from vmharness.execution.call import Caller

JUDGED = Path("judged")


def _columns(ctx: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> dict[str, str]:
    """Columns by channel."""
    found = dict(value.partition("=")[::2] for value in values)
    for channel, column in found.items():
        if not channel or not column:
            raise click.BadParameter(f"{channel}={column} is not of the form CHANNEL=COLUMN")
    return found


@click.command("judge")
@click.argument("what", metavar="CASE FILE... | FOLDER", nargs=-1, required=True)
@CASES
@click.option(
    "--column",
    "columns",
    multiple=True,
    metavar="CHANNEL=COLUMN",
    callback=_columns,
    help="Column of a CSV file that is a channel of the case, where their names differ; repeat the option.",
)
@click.option(
    "--solver", metavar="NAME", help="Name of the solver on the page.  [default: what the files say]"
)
@click.option(
    "--out",
    type=options.FOLDER,
    default=JUDGED,
    metavar="DIR",
    help=f"Folder for the pages.  [default: {JUDGED}]",
)
@click.option("--no-report", is_flag=True, help="Write no pages.")
@options.timeout_option(options.TIMEOUT)
@options.formats
@click.pass_context
def command(
    ctx: click.Context,
    what: tuple[str, ...],
    cases: Path | None,
    columns: dict[str, str],
    solver: str | None,
    out: Path,
    no_report: bool,
    timeout: float,
) -> int:
    """Judge results that another solver has written, as those of a run. Nothing is run.

    CASE is an id or the path of a case folder. FILE is a result file (nodout, glstat, binout, d3plot, CSV, ...), or a
    folder of such files. With FOLDER alone, each of its sub-folders that has the id of a case is judged.

    A result whose channel is in no file is "not reported": neither a pass nor a failure. The command prints which file
    would give it.
    """
    from vmharness.cli.pipeline import IMPORTS, Wanted, write_files, write_page
    from vmharness.cli.summary import summarise
    from vmharness.execution.call import caller

    began = Began(["vm", *ctx.find_root().obj], now(), time.perf_counter())
    whole = len(what) == 1
    found = _in_folder(Path(what[0]), cases) if whole else _one(what[0], what[1:], cases)
    if not found:
        complain(f"no sub-folder of {what[0]} has the id of a case and a result file in it")
        return NOTHING_SELECTED
    files = {entry.id: paths for entry, paths in found}
    wanted = Wanted(
        solver="", data={}, jobs=1, timeout=timeout, root=out, report=not no_report, index=whole and not no_report,
        files=options.files(ctx),
    )  # fmt: skip
    unwritten = []
    with reader() as desk:
        read, outcomes = read_cases(desk, [entry for entry, _ in found], {}, timeout)
        call = caller(desk, timeout + IMPORTS)
        outcomes += [_judged(call, case, files[case.id], columns, solver or "") for case in read]
        for outcome in outcomes:
            _say_read(outcome)
            unwritten += write_page(call, outcome, wanted)
    unwritten += write_files(outcomes, [entry for entry, _ in found], wanted, began)
    summarise(outcomes, unwritten, {}, ctx.find_root().params["debug"])
    if wanted.report:
        say(f"report: {(out if whole else out / outcomes[0].id) / 'index.html'}")
    return exit_code([*(outcome.status for outcome in outcomes), *(file.status for file in unwritten)])


def _judged(
    call: "Caller", case: "Case", files: Sequence[Path], columns: Mapping[str, str], solver: str
) -> Outcome:
    """The outcome of a case by its files, read and judged in another process."""
    from vmharness.suite.judge import judge_files

    match call(partial(judge_files, case, files, columns, solver)):
        case Done(outcome):
            found: Outcome = outcome
            return found
        case Lost(reason):
            return Outcome(case.id, Status.UNJUDGED, f"could not be judged: {reason}")
        case Raised(error, trace):
            return Outcome(case.id, Status.DEFECT, error, traceback=trace)


def _say_read(outcome: Outcome) -> None:
    """Print what was read from where, what was noticed, and what would give the rest."""
    if outcome.run is None:
        return
    solution = outcome.run.solution
    say(f"{outcome.id}: {solution.solver}")
    for what, channels in solution.facts.items():
        say(f"  {what}: {channels}")
    for note in solution.notes:
        say(f"  {note}")
    for channel, reason in solution.unreported.items():
        say(f"  not reported: {channel} {reason}")


def _one(selector: str, paths: Sequence[str], cases: Path | None) -> list[tuple[Entry, list[Path]]]:
    """The case, with its files; raises UsageError if the selector means none or several."""
    try:
        found, unknown = select(cases_folder(cases), (selector,))
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    for problem in unknown.values():
        raise click.UsageError(problem)
    if len(found) > 1:
        raise click.UsageError(
            f"{selector} selects {len(found)} cases; name a folder with one folder for each"
        )
    return [(found[0], [file for path in paths for file in _expanded(Path(path))])]


def _in_folder(folder: Path, cases: Path | None) -> list[tuple[Entry, list[Path]]]:
    """Every case that has a sub-folder with a result file; raises UsageError if `folder` is no folder."""
    if not folder.is_dir():
        raise click.UsageError(f"{folder}: no such folder; name a case and its files, or a folder of folders")
    try:
        known = {entry.id: entry for entry in entries(cases_folder(cases))}
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    found = []
    for place in sorted(path for path in folder.iterdir() if path.is_dir()):
        if place.name not in known:
            complain(f"{place}: no case {place.name}")
        elif files := _expanded(place):
            found.append((known[place.name], files))
        else:
            complain(f"{place}: no result file that is known")
    return found


def _expanded(path: Path) -> list[Path]:
    """The file, or the result files in a folder; raises UsageError if there is neither."""
    from vmharness.results import recognise

    if path.is_dir():
        return [file for file in sorted(path.iterdir()) if file.is_file() and recognise(file) is not None]
    if not path.exists():
        raise click.UsageError(f"{path}: no such file")
    return [path]
