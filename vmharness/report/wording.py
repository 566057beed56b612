"""Sentences of the pages that are the same in every format."""

import math
from collections.abc import Mapping

from vmharness.compare import Verdict
from vmharness.report import number
from vmharness.report.number import DASH, given, positional, share
from vmharness.report.page import Page, PlantedFault, worst_row
from vmharness.result import CaseRun, Row
from vmharness.round_off import ROUND_OFF, rounded
from vmharness.studies.sensitivity import DIGITS, PLACES, Sensitivity, smallest_seen

VISIBLE = 200  # a tolerance of so many times round-off, of which that is half a percent
TARGETS = {
    "analytic": "analytic solution",
    "semi-analytic": "semi-analytic solution",
    "other code": "results of another code",
    "published": "published values",
}
SIGNS = {
    Verdict.PASS: "✓",
    Verdict.FAIL: "✗",
    Verdict.ERROR: "!",
    Verdict.UNREPORTED: "–",
    Verdict.UNREPRESENTABLE: "–",
}


def targets(kind: str) -> str:
    """The origin of the targets in words.

    >>> targets("analytic"), targets("other code")
    ('analytic solution', 'results of another code')
    """
    return TARGETS[kind]


def sign(verdict: Verdict) -> str:
    """The sign alone, where there is no room for a word."""
    return SIGNS[verdict]


def badge(verdict: Verdict) -> str:
    """The verdict with its sign, which is clear without colour.

    >>> badge(Verdict.FAIL)
    '✗ fail'
    """
    return f"{sign(verdict)} {verdict}"


def summary(run: CaseRun) -> str:
    """One line about a run: the reason if it did not pass, else the largest share of a tolerance."""
    if run.verdict is not Verdict.PASS:
        return run.reason or "no result has a verdict"
    worst = worst_row(run)
    line = f"All {len(run.rows)} results are within their tolerances"
    if missing := len(run.unreported):
        judged = len(run.rows) - missing
        line = f"{judged} of {len(run.rows)} results are within their tolerances, {missing} not reported"
    if worst is None:
        return f"{line}."
    if worst.used == 0.0:
        return f"{line}. Their differences from theory are round-off."
    return f"{line}. {worst.key} uses the largest share of its tolerance, {used(worst)}."


def used(row: Row | None) -> str:
    """The share of its tolerance that a result uses.

    It is `round-off` if the error is not above round-off, and the tolerance is so small that round-off could be seen.
    """
    if row is None:
        return DASH
    c = row.comparison
    nothing_else = row.used == 0.0 and c.tolerance.allowed(c.target) < VISIBLE * ROUND_OFF * abs(c.target)
    return "round-off" if nothing_else else share(row.used)


def error(row: Row) -> str:
    """The error of a result in percent, or in its unit if the target is zero; 0 if it is round-off alone."""
    c = row.comparison
    if c.target == 0.0:
        return _in_unit(c.value, row)
    return "0" if used(row) == "round-off" else number.error(c.error_percent, c.tolerance_percent)


def tolerance(row: Row) -> str:
    """The tolerance of a result in percent, or in its unit if the target is zero."""
    c = row.comparison
    return _in_unit(c.tolerance.absolute, row) if c.target == 0.0 else positional(c.tolerance_percent)


def _in_unit(value: float, row: Row) -> str:
    return f"{positional(value, 2)} {row.unit}".rstrip() if math.isfinite(value) else DASH


def changes(page: Page) -> str:
    """The data that were set for this run, with the values of the case."""
    return ", ".join(
        f"{datum.name} = {given(datum.value)} {datum.unit}".strip()
        + f" instead of {given(page.run.case.file.given[datum.name].value)}"
        for column in page.data.values()
        for datum in column
        if datum.name in page.run.case.changed
    )


def moves(fault: PlantedFault) -> list[tuple[str, str]]:
    """Each result that must fail, and how far the fault moves it by theory."""
    return [
        (
            key,
            f"{positional(moved.percent, 4)} %, {rounded(moved.tolerances):.0f} × tolerance" if moved else "",
        )
        for key, moved in fault.moves.items()
    ]


def sensitive(page: Page) -> tuple[dict[str, Mapping[str, Sensitivity]], list[str]]:
    """The data that change a result, with their sensitivities; and the names of the data that change none."""
    moving = {
        name: of
        for name, of in page.sensitivity.items()
        if any(one.percent or one.seen is not None for one in of.values())
    }
    return moving, [name for name in page.sensitivity if name not in moving]


def seen(page: Page, datum: str) -> str:
    """The smallest error of a datum in the deck that makes a result fail, and that result."""
    smallest = smallest_seen(page.sensitivity[datum])
    return f"{positional(rounded(smallest[1], DIGITS), 2)} % ({smallest[0]})" if smallest else DASH


def per_percent(one: Sensitivity) -> str:
    """The change of a target in percent if a datum grows by one percent."""
    return positional(None if one.percent is None else round(rounded(one.percent, DIGITS), PLACES), 4)
