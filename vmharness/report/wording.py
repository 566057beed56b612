"""Sentences that every format of the manual says in the same words."""

from collections.abc import Mapping

from vmharness.compare import Verdict
from vmharness.report.number import DASH, decimals, given, positional, share
from vmharness.report.page import Page, PlantedFault, worst_row
from vmharness.result import CaseRun
from vmharness.studies.sensitivity import Sensitivity, smallest_seen

SIGNS = {Verdict.PASS: "✓", Verdict.FAIL: "✗", Verdict.ERROR: "!"}


def sign(verdict: Verdict) -> str:
    """The sign alone, for where there is no room."""
    return SIGNS[verdict]


def badge(verdict: Verdict) -> str:
    """The verdict with its sign, so that colour is never needed to tell it.

    >>> badge(Verdict.FAIL)
    '✗ fail'
    """
    return f"{sign(verdict)} {verdict}"


def summary(run: CaseRun) -> str:
    """What there is to say of a run in one line: the reason if it did not pass, else its thinnest margin."""
    if run.verdict is not Verdict.PASS:
        return run.reason or "nothing was judged"
    worst = worst_row(run)
    line = f"All {len(run.rows)} results lie within their tolerances"
    return (
        f"{line}; {worst.key} uses the most of its own, {share(worst.comparison.share)}."
        if worst
        else f"{line}."
    )


def changes(page: Page) -> str:
    """The data that are not the case's own, with those that are."""
    return ", ".join(
        f"{datum.name} = {given(datum.value)} {datum.unit}".strip()
        + f" instead of {given(page.run.case.file.given[datum.name].value)}"
        for column in page.data.values()
        for datum in column
        if datum.name in page.run.case.changed
    )


def moves(fault: PlantedFault) -> list[tuple[str, str]]:
    """Each result that must fail, and how far theory says that the fault moves it."""
    return [
        (key, f"{decimals(moved.percent)} %, {moved.tolerances:.0f} × tolerance" if moved else "")
        for key, moved in fault.moves.items()
    ]


def sensitive(page: Page) -> tuple[dict[str, Mapping[str, Sensitivity]], list[str]]:
    """The data that move a target or a reading, with what they do; and the names of those that move none."""
    moving = {
        name: of
        for name, of in page.sensitivity.items()
        if any(one.percent or one.seen is not None for one in of.values())
    }
    return moving, [name for name in page.sensitivity if name not in moving]


def seen(page: Page, datum: str) -> str:
    """From which error of a datum in the deck on a result fails, and which."""
    smallest = smallest_seen(page.sensitivity[datum])
    return f"{positional(smallest[1], 2)} %, by {smallest[0]}" if smallest else DASH
