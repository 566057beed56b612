"""What is said at the end of a run: worst news first."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from vmharness.cli.say import plain_table, say, say_table
from vmharness.suite.outcome import Outcome, Status, worst_first

if TYPE_CHECKING:
    from vmharness.result import CaseRun

COLOURS = {Status.PASS: "green", Status.FAIL: "red"}  # what is neither is yellow


def summarise(outcomes: Iterable[Outcome], again: Mapping[str, str], debug: bool) -> None:
    """Print the table of cases, then for each that did not pass why, and the line of `again` that runs it."""
    ordered = worst_first(outcomes)
    runs = [outcome.run for outcome in ordered if outcome.run is not None]
    if len(runs) == 1 and runs[0].solution.history is not None:
        _results(runs[0])
    _cases(ordered)
    for outcome in ordered:
        if outcome.status is not Status.PASS:
            _explain(outcome, again, debug)
    counts = Counter(outcome.status for outcome in ordered)
    say(", ".join(f"{count} {status}" for status in Status if (count := counts[status])))


def _results(run: "CaseRun") -> None:
    """The manual's table of a case."""
    from rich.text import Text

    table = plain_table("Event", "Result", "Unit")
    for column in ("Target", "Computed", "Error (%)", "Tolerance (%)", "Used (%)"):
        table.add_column(column, justify="right")
    table.add_column("Verdict")
    for row in run.rows:
        c = row.comparison
        numbers = (
            f"{c.target:.6g}",
            f"{c.value:.6g}",
            _number(c.error_percent, "+.4f").replace("-0.0000", "+0.0000"),
            _number(c.tolerance_percent, ".4f"),
            _number(c.share, ".1%").removesuffix("%"),
        )
        style = COLOURS.get(Status(row.verdict), "yellow")
        table.add_row(row.event, row.label, row.unit, *numbers, Text(row.verdict, style))
    say_table(table)


def _cases(outcomes: Sequence[Outcome]) -> None:
    from rich.text import Text

    table = plain_table("Case", "Verdict")
    for column in ("Tolerance used (%)", "Cycles", "Seconds"):
        table.add_column(column, justify="right")
    for outcome in outcomes:
        verdict = Text(outcome.status, COLOURS.get(outcome.status, "yellow"))
        cycles, seconds = "", ""
        if outcome.run is not None:
            cycles, seconds = str(outcome.run.solution.cycles), f"{outcome.run.seconds:.2f}"
        table.add_row(outcome.id, verdict, _number(outcome.share, ".1%").removesuffix("%"), cycles, seconds)
    say_table(table)


def _explain(outcome: Outcome, again: Mapping[str, str], debug: bool) -> None:
    say(f"{outcome.id}: {outcome.status}" + (f": {outcome.reason}" if outcome.reason else ""))
    if debug and outcome.traceback:
        say(outcome.traceback)
    if outcome.id in again:
        say(f"  again: {again[outcome.id]}")


def _number(value: float | None, form: str) -> str:
    return "–" if value is None else format(value, form)
