"""Sensitivity of each target to each given datum, and the smallest error of a datum that makes a result fail.

    s = d ln target / d ln datum        percent per percent

by central differences of the formulas, of the fourth order: (4 D(h) - D(2 h)) / 3 with D(h) = (f(1+h) - f(1-h)) / 2h.
If D(h) and D(2 h) do not agree, the formula has a kink or jump here, and there is no derivative.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from vmharness.case import Case, CaseError
from vmharness.case.case import evaluate_theory
from vmharness.case.tolerance import allowed_difference
from vmharness.round_off import smallest
from vmharness.studies.faults.declared import change_seen, in_deck

STEP = 1e-4  # h, as a fraction of the datum
POINTS = (1.0 - 2.0 * STEP, 1.0 - STEP, 1.0 + STEP, 1.0 + 2.0 * STEP)
AGREE = 0.1  # D(h) and D(2 h) differ by less than this fraction of the larger one
NOISE = 1e-8  # a derivative below this is round-off of the formula
DIGITS, PLACES = 6, 9  # of a derivative that are no round-off: that of the formula, over STEP


@dataclass(frozen=True)
class Sensitivity:
    """Sensitivity of one result to one datum."""

    percent: float | None  # of the target per percent of the datum; None where that has no meaning
    seen: (
        float | None
    )  # percent by which the deck's datum must be wrong to fail the result, to first order; or never


def sensitivities(case: Case) -> dict[str, dict[str, Sensitivity]]:
    """Sensitivities by datum, then by key of the result; a datum of zero is left out."""
    return {name: _of(case, name) for name, value in case.given.items() if value != 0.0}


def smallest_seen(of: Mapping[str, Sensitivity]) -> tuple[str, float] | None:
    """The result that sees the smallest fault of a datum, and that size in percent; None where none sees any.

    Of results that see equal ones it is the first.
    """
    seen = [(one.seen, key) for key, one in of.items() if one.seen is not None]
    if not seen:
        return None
    size, key = smallest(seen, lambda pair: pair[0])
    return key, size


def derivative(values: Sequence[float]) -> float | None:
    """df/dx at x = 1 of the `values` of f at POINTS, or None where f has none there.

    >>> round(derivative([x**3 for x in POINTS]), 9), derivative([abs(x - 1.00005) for x in POINTS])
    (3.0, None)
    """
    lowest, low, high, highest = values
    near, far = (high - low) / (2.0 * STEP), (highest - lowest) / (4.0 * STEP)
    if not abs(near - far) <= AGREE * max(abs(near), abs(far)) + NOISE:
        return None
    slope = (4.0 * near - far) / 3.0
    return slope if abs(slope) > NOISE else 0.0


def _of(case: Case, name: str) -> dict[str, Sensitivity]:
    keys = [result.key for result in case.file.results]
    try:
        others = [_with(case, name, x) for x in POINTS]
    except CaseError:  # theory has no values there
        return dict.fromkeys(keys, Sensitivity(None, None))
    deck = in_deck(case, name)
    return {
        key: Sensitivity(_percent(case, others, key), _seen(case, others, key) if deck else None)
        for key in keys
    }


def _with(case: Case, name: str, factor: float) -> Case:
    """The theory for another value of a datum, whether or not the deck has it."""
    given = {**case.given, name: factor * case.given[name]}
    return replace(case, given=given, theory=evaluate_theory(case.id, case.file, given, case.formulas))


def _percent(case: Case, others: Sequence[Case], key: str) -> float | None:
    target = case.target(key)
    try:
        return derivative([other.target(key) / target for other in others]) if target else None
    except CaseError:
        return None


def _seen(case: Case, others: Sequence[Case], key: str) -> float | None:
    """100 allowed difference / |d reading / d ln datum|, where the datum is the deck's alone."""
    allowed = allowed_difference(case, key)
    scale = (
        abs(case.target(key)) or allowed
    )  # the round-off of a change is of the target, not of the tolerance
    try:
        changes = [change_seen(case, other, key) for other in others]
    except CaseError:
        return None
    known = [change / scale for change in changes if change is not None] if allowed else []
    slope = derivative(known) if len(known) == len(POINTS) else None
    return 100.0 * allowed / scale / abs(slope) if slope else None
