"""Bounds of tolerances and error budgets: finer ones no solver could hold, coarser ones every solver would.

    FINEST <= relative < 1,     FINEST |target| <= absolute + relative |target| < s

s is the size of the result: |target|; where that is near zero, the largest target of its channel, or else the largest
target, datum or line of theory of its unit.
"""

import sys

from vmharness.case.case import Case
from vmharness.case.decode import FILE
from vmharness.case.error import CaseError
from vmharness.case.tolerance import allowed_difference, budget_lines
from vmharness.formula import DIMENSIONLESS, Unit

FINEST = 10.0 * sys.float_info.epsilon  # of a number: ten times the distance of doubles
NEAR_ZERO = 1e-6  # of s: a smaller target has no useful relative error


def check_bounds(case: Case) -> None:
    """Raise CaseError, with its place, for the first tolerance or line of the error budget out of bounds."""
    for number, result in enumerate(case.file.results, 1):
        if why := _tolerance(case, result.key):
            raise _wrong(case, f"[results] {number}", why)
    for number, (_, values) in enumerate(budget_lines(case), 1):
        for key, value in values.items():
            if why := _budget(case, key, value):
                raise _wrong(case, f"[budget] {number}: {key}", why)


def _wrong(case: Case, place: str, what: str) -> CaseError:
    return CaseError(f"{case.folder.name}/{FILE}: {place}: {what}")


def _tolerance(case: Case, key: str) -> str:
    """What is wrong with the tolerance of a result, or nothing."""
    result, target = case.result(key), case.target(key)
    relative, unit = result.tolerance.relative, Unit(result.unit)
    if target == 0.0 and result.tolerance.absolute == 0.0:
        return "the target is 0: only an absolute tolerance can judge it"
    if relative and not FINEST <= relative < 1.0:
        return f"relative = {relative:g}: {_TOO_FINE if relative < FINEST else _TOO_COARSE}"
    if not result.tolerance.absolute:
        return ""
    size, factor = scale(case, key), case.units.factor(unit)
    if size == 0.0:
        return (
            f"absolute = {result.tolerance.absolute:g}: no datum, line of theory or other target is in "
            f"{result.unit or 'plain numbers'}, so nothing says how large the result could be: add one"
        )
    allowed, least = allowed_difference(case, key), FINEST * (abs(target) or size)
    if not least <= allowed < size:
        what = f"the tolerance, {allowed / factor:g}, of a quantity of the size {size / factor:.4g} {result.unit}"
        return f"{what.rstrip()}: {_TOO_FINE if allowed < least else _TOO_COARSE}"
    return ""


_TOO_FINE = f"at least {FINEST:.2g} of the size is necessary: numbers of 64 bits hold no finer one"
_TOO_COARSE = "it must be below the size itself: a result of zero, or of the wrong sign, would pass"


def _budget(case: Case, key: str, value: float) -> str:
    """What is wrong with a line of the error budget of a result, or nothing."""
    if value < 0.0:
        return f"{value:g} is negative: errors are added by their size"
    size = 1.0 if case.target(key) else scale(case, key)
    if not value < size:
        return f"{value:g} is not below {size:.4g}: an error of the size of the result itself"
    return ""


def scale(case: Case, key: str) -> float:
    """The size of a result, in consistent units: |target|; if that is near zero, that of its channel, else of its unit.

    It is 0 if the target is zero and nothing else of the case has its unit.
    """
    target = abs(case.target(key))
    largest = max(_of_channel(case, key)) or max(_of_unit(case, key), default=0.0)
    if target > NEAR_ZERO * largest:
        return target
    return largest or float(Unit(case.result(key).unit).dimension == DIMENSIONLESS)


def _of_channel(case: Case, key: str) -> list[float]:
    """Sizes of the targets of the result's channel."""
    channel = case.result(key).channel
    return [abs(case.target(other.key)) for other in case.file.results if other.channel == channel]


def _of_unit(case: Case, key: str) -> list[float]:
    """Sizes of all targets, data and lines of theory in the result's unit."""
    dimension = Unit(case.result(key).unit).dimension
    targets = [
        case.target(other.key) for other in case.file.results if Unit(other.unit).dimension == dimension
    ]
    others = [value for name, value in case.values.items() if case.dimensions[name] == dimension]
    return [abs(value) for value in (*targets, *others)]
