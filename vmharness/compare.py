"""Target, computed value, tolerance: a verdict, with its reason."""

import math
from dataclasses import dataclass
from enum import StrEnum


class Verdict(StrEnum):
    """What can be said of a result; the worst of its results is said of a case."""

    PASS = "pass"
    FAIL = "fail"  # judged, and wrong
    ERROR = "error"  # could not be judged


@dataclass(frozen=True)
class Tolerance:
    """How far a value may lie from its target: |value - target| <= absolute + relative |target|."""

    relative: float = 0.0
    absolute: float = 0.0

    def allowed(self, target: float) -> float:
        """The largest accepted difference, in the unit of the target."""
        return self.absolute + self.relative * abs(target)


@dataclass(frozen=True)
class Comparison:
    """One target against one computed value; percentages are of the target, None where that has no meaning."""

    target: float
    value: float
    tolerance: Tolerance
    error_percent: float | None  # signed: 100 (value - target)/target, as the manual prints it
    tolerance_percent: float | None
    share: float | None  # |value - target| / allowed difference
    verdict: Verdict
    reason: str  # empty for a pass


def compare(target: float, value: float, tolerance: Tolerance, scale: float = 0.0) -> Comparison:
    """Judge `value` against `target`.

    `scale` is the size of the quantity (the largest magnitude in its history): a target below a millionth of it is
    near zero, where a relative tolerance means nothing and an absolute one must be given.

    >>> compare(2.0, 2.002, Tolerance(relative=0.01)).verdict
    <Verdict.PASS: 'pass'>
    >>> compare(0.0, 1e-9, Tolerance(relative=0.01)).reason
    'the target 0 is near zero: only an absolute tolerance can judge it'
    """
    difference = value - target
    allowed = tolerance.allowed(target)
    usual = math.isfinite(value) and math.isfinite(target)
    percent = 100.0 / target if usual and target else None
    verdict, reason = _judge(target, value, tolerance, scale)
    return Comparison(
        target=target,
        value=value,
        tolerance=tolerance,
        error_percent=difference * percent if percent else None,
        tolerance_percent=allowed * abs(percent) if percent else None,
        share=abs(difference) / allowed if usual and allowed > 0.0 else None,
        verdict=verdict,
        reason=reason,
    )


def _judge(target: float, value: float, tolerance: Tolerance, scale: float) -> tuple[Verdict, str]:
    if not math.isfinite(target):
        return Verdict.ERROR, f"the target is {target}"
    if not math.isfinite(value):
        return Verdict.FAIL, f"the computed value is {value}"
    if (tolerance.absolute == 0.0 and abs(target) <= 1e-6 * scale) or (
        target == 0.0 and tolerance.absolute == 0.0
    ):
        return Verdict.ERROR, f"the target {target:g} is near zero: only an absolute tolerance can judge it"
    allowed = tolerance.allowed(target)
    if abs(value - target) <= allowed:
        return Verdict.PASS, ""
    return (
        Verdict.FAIL,
        f"{value:.7g} differs from {target:.7g} by {abs(value - target):.3g}, allowed {allowed:.3g}",
    )


def worst(verdicts: list[Verdict]) -> Verdict:
    """The verdict on many: nothing judged is an error, then error, fail, pass."""
    for verdict in (Verdict.ERROR, Verdict.FAIL, Verdict.PASS):
        if verdict in verdicts:
            return verdict
    return Verdict.ERROR
