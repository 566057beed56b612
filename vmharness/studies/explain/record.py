"""The error of a result split into its causes; each part comes from runs or from a bound.

Let v(h, s) be the result of a run with the time step h that is read from samples s apart:

    v(h, h) - target = [v(h, h) - v(h/4, h)] + [v(h/4, h) - v(h/4, h/4)] + [v(h/4, h/4) - target]
                            time step                  sampling                   the rest

Both brackets end at h/4; the part below h/4 is extrapolated.

Time step (Richardson): with the differences d1, d2 of two halvings and r = d1/d2, the whole part is
d1 + d2 + d2/(r - 1). If the sequence does not converge, the part is d1 + d2 with the uncertainty d2.

Sampling: the run with h/4 is read from every sample, every second and every fourth one. The mean over the phases is
a + b s^p for the spacing s, which gives the error at s = h/4. The uncertainty is the distance of one phase from the
mean.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from vmharness.round_off import ROUND_OFF, rounded
from vmharness.studies.maker import Maker

SAMPLING = "sampling"
FALLS = 1.5  # d1/d2 of a sequence that converges: of an order above 0.58
SLOWEST = 20.0  # d1/d2 above this is round-off in d2, or chance


@dataclass(frozen=True)
class Part:
    """One cause: its part of the error, in the unit of the result, and the uncertainty of that part."""

    cause: str
    value: float
    open: float = 0.0  # uncertainty: the part may be larger or smaller by this
    how: str = "runs"  # or bound, or difference (the unexplained rest)


@dataclass(frozen=True)
class Explained:
    """The error value - target of one result as the sum of its parts; the last part is the unexplained rest."""

    key: str
    label: str
    unit: str
    target: float
    value: float
    allowed: float  # the tolerance, in the result's unit
    parts: list[Part]

    @property
    def difference(self) -> float:
        """The error value - target: the sum of the parts."""
        return sum(part.value for part in self.parts)

    @property
    def unexplained(self) -> Part:
        """The unexplained rest."""
        return self.parts[-1]


@dataclass(frozen=True)
class Column:
    """A published column: the reading that gives most of its figures, and its errors in parts."""

    name: str
    kind: str  # target, or computed
    reading: str  # in words; empty for a target
    also: list[float]  # other intervals that give as many figures
    same: list[str]  # keys of the figures that it gives
    others: dict[
        str, str
    ]  # by key: a reading at the same interval that gives a figure which this one does not
    results: list[Explained]


@dataclass(frozen=True)
class ExplainRecord:
    """The record of `vm explain`."""

    case: str
    case_sha256: str  # of its inputs
    results: list[Explained]
    columns: list[Column] = field(default_factory=list)  # published
    notes: list[str] = field(default_factory=list)  # causes that could not be separated, and why
    made_by: Maker | None = None  # None in records of before it was kept


def halved(d1: float, d2: float, cause: str) -> Part:
    """The part of a cause that is halved twice, from the two differences of the result.

    >>> halved(3.0, 0.75, "time step")  # second order: 4 in all
    Part(cause='time step', value=4.0, open=0.0, how='runs')
    >>> halved(3.0, -1.0, "time step")
    Part(cause='time step', value=2.0, open=1.0, how='runs')
    """
    if d2 and FALLS <= d1 / d2 <= SLOWEST:
        return Part(cause, d1 + d2 + d2 / (d1 / d2 - 1.0))
    return Part(cause, d1 + d2, abs(d2))


def sampled(coarse: float, phases: Sequence[Sequence[float]]) -> Part:
    """The part of the sampling: `coarse` less the limit of the readings with spacings of 1, 2 and 4 samples.

    >>> sampled(0.25, ([0.25], [0.25, 1.25], [0.25, 1.25, 2.25, 3.25]))  # the first sample of those 1 apart
    Part(cause='sampling', value=0.5, open=0.5, how='runs')
    """
    one, two, four = (sum(values) / len(values) for values in phases)
    near, far = two - one, four - two
    spread = max(abs(value - two) for value in phases[1])
    if near and FALLS <= far / near <= SLOWEST:  # 2^p
        beyond = near / (far / near - 1.0)
        return Part(SAMPLING, coarse - one + beyond, spread)
    return Part(SAMPLING, coarse - one, max(abs(near), spread))


def explained(
    key: str, label: str, unit: str, target: float, value: float, allowed: float, parts: list[Part]
) -> Explained:
    """The parts and the unexplained rest of the error."""
    rest = Part(
        "unexplained",
        value - target - sum(part.value for part in parts),
        sum(part.open for part in parts),
        "difference",
    )
    finest = max(1e-6 * allowed, ROUND_OFF * abs(target))  # below it are digits that no two machines share
    shown = [_rounded(part, finest) for part in [*parts, rest]]
    return Explained(key, label, unit, rounded(target, 10), rounded(value, 10), allowed, shown)


def _rounded(part: Part, finest: float) -> Part:
    def tidy(number: float) -> float:
        return rounded(number, 3) if abs(number) > finest else 0.0

    return Part(part.cause, tidy(part.value), tidy(part.open), part.how)
