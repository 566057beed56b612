"""Summary at the end of a run: failures first."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from vmharness.cli.say import plain_table, say, say_table
from vmharness.suite.outcome import Outcome, Status, Unwritten, worst_first

if TYPE_CHECKING:
    from rich.text import Text

    from vmharness.result import CaseRun

COLOURS = {Status.PASS: "green", Status.FAIL: "red"}  # all others are yellow


def summarise(
    outcomes: Iterable[Outcome], unwritten: Iterable[Unwritten], again: Mapping[str, str], debug: bool
) -> None:
    """Print the table of cases, then the reason for each that did not pass, and the command of `again` that runs it.

    Files that could not be written follow.
    """
    ordered = worst_first(outcomes)
    runs = [outcome.run for outcome in ordered if outcome.run is not None]
    if len(runs) == 1 and runs[0].solution.history is not None:
        _results(runs[0])
    _cases(ordered)
    for outcome in ordered:
        if outcome.status is not Status.PASS:
            _explain(outcome, again, debug)
    for file in unwritten:
        say(f"{file.status}: {file.what} cannot be written: {file.reason}")
        if debug and file.traceback:
            say(file.traceback)
    counts = Counter(outcome.status for outcome in ordered)
    say(", ".join(f"{count} {status}" for status in Status if (count := counts[status])))


def _results(run: "CaseRun") -> None:
    """The table of the results of one case, with the share of its tolerance that each result uses."""
    table = plain_table("Result", "Target", "Computed", "Error (%)", "Used (%)", "Verdict")
    for event, rows in run.groups:
        table.add_row(event)
        for row in rows:
            c = row.comparison
            table.add_row(
                f"  {row.label} ({row.unit})" if row.unit else f"  {row.label}",
                f"{c.target:.6g}",
                f"{c.value:.6g}",
                _number(c.error_percent, "+.4f").replace("-0.0000", "+0.0000"),
                _number(c.share, ".1%").removesuffix("%"),
                _coloured(Status(row.verdict)),
            )
    say_table(table)


def _cases(outcomes: Sequence[Outcome]) -> None:
    table = plain_table("Case", "Verdict", "Tolerance used (%)", "Cycles", "Seconds")
    for outcome in outcomes:
        cycles, seconds = "", ""
        if outcome.run is not None:
            cycles, seconds = str(outcome.run.solution.cycles), f"{outcome.run.seconds:.2f}"
        share = _number(outcome.share, ".1%").removesuffix("%")
        table.add_row(outcome.id, _coloured(outcome.status), share, cycles, seconds)
    say_table(table)


def _coloured(status: Status) -> "Text":
    from rich.text import Text

    return Text(status, COLOURS.get(status, "yellow"))


def _explain(outcome: Outcome, again: Mapping[str, str], debug: bool) -> None:
    say(f"{outcome.id}: {outcome.status}" + (f": {outcome.reason}" if outcome.reason else ""))
    if debug and outcome.traceback:
        say(outcome.traceback)
    if outcome.id in again:
        say(f"  run it again: {again[outcome.id]}")


def _number(value: float | None, form: str) -> str:
    return "–" if value is None else format(value, form)
