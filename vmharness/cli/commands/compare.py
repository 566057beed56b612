"""`vm compare`: two runs, result by result."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.options import FILE
from vmharness.cli.say import complain, say, say_rows, write_file
from vmharness.suite.outcome import EXIT_CODES, Status

if TYPE_CHECKING:
    from vmharness.export import Run
    from vmharness.studies.compare import Pair

RUN = click.Path(exists=True, dir_okay=False, path_type=Path)


@click.command("compare")
@click.argument("first", metavar="A", type=RUN)
@click.argument("second", metavar="B", type=RUN)
@click.option("--all", "every", is_flag=True, help="Also show results that are equal to the last digit.")
@click.option("--json", type=FILE, metavar="FILE", help="Also write the comparison as JSON.")
def command(first: Path, second: Path, every: bool, json: Path | None) -> int:
    """Compare two runs, saved by `vm run --json`.

    They may differ in solver, version or machine. The command fails if a result of A is missing in B, or has a
    worse verdict there.
    """
    import msgspec

    from vmharness.studies.compare import pairs

    runs = [_read(path) for path in (first, second)]
    found = pairs(*runs)
    _show(runs, found, every)
    if json is not None:
        write_file(json, msgspec.json.format(msgspec.json.encode(found), indent=1).decode() + "\n")
    return EXIT_CODES[Status.FAIL if any(pair.worse for pair in found) else Status.PASS]


def _read(path: Path) -> "Run":
    import msgspec

    from vmharness.export import SCHEMA, Numbered, Run

    try:
        content = path.read_bytes()
        number = msgspec.json.decode(content, type=Numbered).schema
        if number == SCHEMA:
            return msgspec.json.decode(content, type=Run)
    except (OSError, msgspec.MsgspecError) as error:
        raise click.UsageError(f"{path}: not a file of `vm run --json`: {error}") from None
    raise click.UsageError(
        f"{path}: schema {number}, but only {SCHEMA} can be read; write the file again with `vm run --json`"
    )


def _show(runs: list["Run"], found: list["Pair"], every: bool) -> None:
    from vmharness.report.blocks import Table

    for name, run in zip("AB", runs, strict=True):
        solvers = ", ".join(dict.fromkeys(case.solver for case in run.cases if case.solver))
        say(f"{name}: {solvers or 'no solver'}; vmharness {run.version}; {len(run.cases)} cases")
    differing = [pair for pair in found if every or pair.first != pair.second or pair.worse or pair.remark]
    head = ["Case", "Result", "A", "B", "B - A (%)", "Of tolerance (%)", "Verdict", ""]
    if differing:
        say_rows(Table(head, [_row(pair) for pair in differing], numbers=2))
    say(f"{len(found) - len(differing)} results are equal, {len(differing)} are shown")
    for pair in found:
        if pair.worse:
            complain(f"{pair.case} {pair.key}: {pair.verdicts[0]} in A, {pair.verdicts[1]} in B")


def _row(pair: "Pair") -> list[str]:
    verdict = pair.verdicts[0] if len(set(pair.verdicts)) == 1 else " -> ".join(pair.verdicts)
    return [
        pair.case,
        f"{pair.key} ({pair.unit})" if pair.unit else pair.key,
        *("–" if value is None else f"{value:.9g}" for value in (pair.first, pair.second)),
        "–" if pair.percent is None else f"{pair.percent:+.3g}",
        "–" if pair.share is None else f"{100.0 * pair.share:.3g}",
        verdict,
        pair.remark,
    ]
