"""Tolerances checked against the error budgets of their results."""

from collections.abc import Mapping

from vmharness.case.case import Case
from vmharness.case.format import Budget
from vmharness.compare import Tolerance
from vmharness.formula import Unit
from vmharness.round_off import ROUND_OFF

LOOSE = 10.0  # largest ratio of tolerance to budget that is not doubtful


def budget_lines(case: Case) -> list[tuple[Budget, Mapping[str, float]]]:
    """Each line of the error budget, with its fractions of the targets by key."""
    return [
        (line, {key: case.evaluate(f"budget {number} {key}") for key in line.relative})
        for number, line in enumerate(case.file.budget, 1)
    ]


def budget(case: Case, key: str) -> float | None:
    """The sum of the lines of the error budget for a result; None without a line.

    As a fraction of its target; where that is zero, as a difference in the result's unit.
    """
    fractions = [values[key] for _, values in budget_lines(case) if key in values]
    return sum(fractions) if fractions else None


def allowed_difference(case: Case, key: str) -> float:
    """How far a result may lie from its target, in consistent units."""
    tolerance, factor = case.result(key).tolerance, case.units.factor(Unit(case.result(key).unit))
    return Tolerance(tolerance.relative, tolerance.absolute * factor).allowed(case.target(key))


def allowed(case: Case, key: str) -> float:
    """The tolerance of a result, as a fraction of its target; where that is zero, in the result's unit."""
    scale = abs(case.target(key)) or case.units.factor(Unit(case.result(key).unit))
    return allowed_difference(case, key) / scale


def review(case: Case) -> tuple[list[str], list[str]]:
    """Sentences on results with a budget above the tolerance, and on results with a tolerance far above the budget.

    The first would fail a correct solver, the second would pass a wrong one.
    """
    tight, loose = [], []
    for result in case.file.results:
        key, expected, accepted = result.key, budget(case, result.key), allowed(case, result.key)
        if expected is None:
            loose.append(f"{key}: no error budget gives a reason for the tolerance, {accepted:.2g}")
        elif expected > accepted:
            tight.append(f"{key}: the error budget, {expected:.2g}, exceeds the tolerance, {accepted:.2g}")
        elif accepted > LOOSE * expected:
            loose.append(
                f"{key}: the tolerance, {accepted:.2g}, is more than {LOOSE:g} times the budget, {expected:.2g}"
            )
    return tight, loose


def review_measured(case: Case, errors: Mapping[str, float]) -> list[str]:
    """Sentences on results with a measured error, a fraction of the target by key, above the error budget.

    Such a result may pass, but its error has a cause that the budget does not name.
    """
    budgets = {key: budget(case, key) for key in errors}
    return [
        f"{key}: the measured error, {abs(errors[key]):.2g}, exceeds the error budget, {expected:.2g}"
        for key, expected in budgets.items()
        if expected is not None and abs(errors[key]) > expected + ROUND_OFF
    ]
