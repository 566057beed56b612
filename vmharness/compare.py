"""Comparison of a computed value with its target: a verdict and its reason."""

import math
from dataclasses import dataclass
from enum import StrEnum


class Verdict(StrEnum):
    """Verdict on a result; the verdict on a case is the worst of its results."""

    PASS = "pass"
    FAIL = "fail"  # out of tolerance
    ERROR = "error"  # could not be judged
    UNREPRESENTABLE = "not representable"  # the solver cannot pose the problem: neither a pass nor a failure
    UNREPORTED = "not reported"  # the results do not hold the quantity: neither a pass nor a failure


@dataclass(frozen=True)
class Tolerance:
    """Tolerance of a value: |value - target| <= absolute + relative |target|."""

    relative: float = 0.0
    absolute: float = 0.0

    def allowed(self, target: float) -> float:
        """The largest accepted difference, in the unit of the target."""
        return self.absolute + self.relative * abs(target)


@dataclass(frozen=True)
class Comparison:
    """A computed value compared with its target; percentages refer to the target, None if it is zero."""

    target: float
    value: float
    tolerance: Tolerance
    error_percent: float | None  # signed: 100 (value - target)/target, as the manual prints it
    tolerance_percent: float | None
    share: float | None  # |value - target| / allowed difference
    verdict: Verdict
    reason: str  # empty for a pass


def compare(target: float, value: float, tolerance: Tolerance, scale: float = 0.0) -> Comparison:
    """Compare `value` with `target`.

    `scale` is the largest magnitude of the quantity in its history. A target below a millionth of it is near zero: a
    relative tolerance has no meaning there, and an absolute tolerance is necessary.

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
    """The worst of many verdicts; an error if nothing was judged.

    >>> worst([Verdict.PASS, Verdict.UNREPORTED]), worst([Verdict.UNREPORTED])
    (<Verdict.PASS: 'pass'>, <Verdict.ERROR: 'error'>)
    """
    for verdict in (Verdict.ERROR, Verdict.FAIL, Verdict.PASS, Verdict.UNREPRESENTABLE):
        if verdict in verdicts:
            return verdict
    return Verdict.ERROR
