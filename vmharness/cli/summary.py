"""Summary at the end of a run: failures first."""

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from vmharness.cli.say import plain_table, say, say_table, width
from vmharness.compare import Comparison, Verdict
from vmharness.suite.outcome import Outcome, Status, Unwritten, worst_first

if TYPE_CHECKING:
    from rich.text import Text

    from vmharness.result import CaseRun, Row

NARROW = 72  # columns that the table of results needs
SMALL = 1e-4  # percent: errors are in powers of ten where the tolerance is smaller
COLOURS: dict[str, str] = {Status.PASS: "green", Status.FAIL: "red"}  # all others are yellow


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
    """The results of one case, with the share of its tolerance that each uses: a table, or lines in a narrow window."""
    if width() < NARROW:
        for row in run.rows:
            say(f"{row.verdict}: {_line(row)}; {_number(row.comparison.share, '.1%')} used")
        return
    table = plain_table("Result", "Target", "Computed", "Error (%)", "Used (%)", "Verdict")
    for event, rows in run.groups:
        table.add_row(event)
        for row in rows:
            c = row.comparison
            table.add_row(
                f"  {row.label} ({row.unit})" if row.unit else f"  {row.label}",
                f"{c.target:.6g}",
                "–" if row.verdict is Verdict.UNREPORTED else f"{c.value:.6g}",
                _error(c),
                _number(c.share, ".1%").removesuffix("%"),
                _coloured(row.verdict),
            )
    say_table(table)


def _error(comparison: "Comparison") -> str:
    """The error in percent; digits follow the tolerance, so that an error which uses a part of it is not shown as 0."""
    if comparison.error_percent is None:
        return "–"
    if (comparison.tolerance_percent or 1.0) < SMALL and abs(comparison.error_percent) < 1e3 * SMALL:
        return f"{comparison.error_percent:+.1e}"
    places = 4 if abs(comparison.error_percent) >= 1e3 * SMALL else _places(comparison)
    return f"{round(comparison.error_percent, places) + 0.0:+.{places}f}"


def _cases(outcomes: Sequence[Outcome]) -> None:
    table = plain_table("Case", "Verdict", "Tolerance used (%)", "Cycles", "Seconds")
    for outcome in outcomes:
        cycles, seconds = "", ""
        if outcome.run is not None:
            cycles, seconds = str(outcome.run.solution.cycles), f"{outcome.run.seconds:.2f}"
        share = _number(outcome.share, ".1%").removesuffix("%")
        table.add_row(outcome.id, _coloured(outcome.status), share, cycles, seconds)
    say_table(table)


def _coloured(status: Status | Verdict) -> "Text":
    from rich.text import Text

    return Text(status, COLOURS.get(str(status), "yellow"))


def _explain(outcome: Outcome, again: Mapping[str, str], debug: bool) -> None:
    """Say why a case did not pass: every result that does not, or the reason for which none could be judged."""
    lines = [_line(row) for row in _not_passed(outcome.run)]
    known = bool(lines) and outcome.run is not None and outcome.reason == outcome.run.reason
    reason = f": {outcome.reason}" if outcome.reason and not known else ""
    say(f"{outcome.id}: {outcome.status}{reason}")
    for line in lines:
        say(f"  {line}")
    if debug and outcome.traceback:
        say(outcome.traceback)
    if outcome.id in again:
        say(f"  run it again: {again[outcome.id]}")


def _not_passed(run: "CaseRun | None") -> "list[Row]":
    """The results that a finished run does not pass; none where it could not be judged."""
    if run is None or run.solution.failure or run.solution.unrepresentable:
        return []
    return [row for row in run.rows if row.verdict is not Verdict.PASS]


def _line(row: "Row") -> str:
    """A result in a line: key, value and target with their unit; error and tolerance in percent, or else the reason."""
    c = row.comparison
    if row.verdict is Verdict.UNREPORTED:
        return f"{row.key}: not reported: {c.reason}"
    unit = f" {row.unit}" if row.unit else ""
    line = f"{row.key}: {c.value:.7g}{unit}, target {c.target:.7g}{unit}"
    if c.error_percent is not None and c.tolerance_percent is not None:
        return f"{line}; error {_error(c)} %, tolerance {c.tolerance_percent:.2g} %"
    return f"{line}; {c.reason}" if c.reason else line  # of a target of zero there is no percent


def _places(comparison: "Comparison") -> int:
    """Decimal places of an error in percent: two digits of the tolerance, at least 4."""
    tolerance = comparison.tolerance_percent
    return max(4, 1 - math.floor(math.log10(tolerance))) if tolerance else 4


def _number(value: float | None, form: str) -> str:
    return "–" if value is None else format(value, form)
