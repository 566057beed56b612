"""Whether a tolerance follows from the error budget of its result."""

from vmharness.case import Case
from vmharness.formula import Unit

LOOSE = 10.0  # a tolerance above so many budgets accepts what the budget cannot explain


def budget(case: Case, key: str) -> float | None:
    """The sum of the lines of the error budget for a result, as a fraction of its target; None without a line."""
    lines = [
        case.evaluate(f"budget {number} {key}")
        for number, line in enumerate(case.file.budget, 1)
        if key in line.relative
    ]
    return sum(lines) if lines else None


def allowed(case: Case, key: str) -> float:
    """The tolerance of a result, as a fraction of its target; infinite where the target is zero."""
    tolerance, target = case.result(key).tolerance, case.target(key)
    if tolerance.absolute == 0.0:
        return tolerance.relative
    absolute = tolerance.absolute * case.units.factor(Unit(case.result(key).unit))
    return tolerance.relative + (absolute / abs(target) if target else float("inf"))


def review(case: Case) -> tuple[list[str], list[str]]:
    """Results whose budget exceeds their tolerance, and those whose tolerance no budget justifies; as sentences.

    The first would fail a solver that is right, the second pass one that is wrong.
    """
    tight, loose = [], []
    for result in case.file.results:
        key, expected, accepted = result.key, budget(case, result.key), allowed(case, result.key)
        if expected is None:
            loose.append(f"{key}: no error budget says why the tolerance is {accepted:.2g}")
        elif expected > accepted:
            tight.append(f"{key}: the error budget, {expected:.2g}, exceeds the tolerance, {accepted:.2g}")
        elif accepted > LOOSE * expected and target_is_not_zero(case, key):
            loose.append(
                f"{key}: the tolerance, {accepted:.2g}, is over {LOOSE:g} times the budget, {expected:.2g}"
            )
    return tight, loose


def target_is_not_zero(case: Case, key: str) -> bool:
    """Fractions of a target of zero mean nothing."""
    return case.target(key) != 0.0
