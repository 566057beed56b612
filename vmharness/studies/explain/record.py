"""Where the difference of a result from theory comes from, cause by cause, each from runs or a bound.

With v(h, s) the result of a run with steps of h, read from samples s apart,

    v(h, h) - target = [v(h, h) - v(h/4, h)] + [v(h/4, h) - v(h/4, h/4)] + [v(h/4, h/4) - target]
                            time step                  sampling                   the rest

Both brackets stop at h/4. What lies beyond follows for the time step from h/2, if the differences fall in a fixed ratio
(Richardson): d1 + d2 + d2/(r - 1) for the differences d1, d2 of two halvings and r = d1/d2. Where they do not, d2 is
left open. For the sampling it follows from the motion at h/4 read from every sample, every second and every fourth: the
mean of each over its phases goes as a + b s^p with the spacing s, and b is the mean error of the finest. How far one
phase lies from the mean is left open.
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
    """One cause: how far it moves the result, in the result's unit, and how much of that is open."""

    cause: str
    value: float
    open: float = 0.0  # the part may be larger or smaller by this
    how: str = "runs"  # or bound, or difference: what is left


@dataclass(frozen=True)
class Explained:
    """value - target of one result as the sum of its parts, the last of which is what is not explained."""

    key: str
    label: str
    unit: str
    target: float
    value: float
    allowed: float  # the tolerance, in the result's unit
    parts: list[Part]

    @property
    def difference(self) -> float:
        """value - target, which the parts add up to."""
        return sum(part.value for part in self.parts)

    @property
    def unexplained(self) -> Part:
        """What no run accounts for."""
        return self.parts[-1]


@dataclass(frozen=True)
class Column:
    """A published column: the reading that gives most of its digits, and its differences from theory in parts."""

    name: str
    kind: str  # target, or computed
    reading: str  # in words; empty for a target
    also: list[float]  # other intervals that give as many digits
    same: list[str]  # keys of the figures that it gives
    others: dict[
        str, str
    ]  # by key: a reading at the same interval that gives a figure which this one does not
    results: list[Explained]


@dataclass(frozen=True)
class ExplainRecord:
    """All that `vm explain` finds out about a case."""

    case: str
    case_sha256: str  # of its inputs
    results: list[Explained]
    columns: list[Column] = field(default_factory=list)  # published
    notes: list[str] = field(default_factory=list)  # what was not separated, and why
    made_by: Maker | None = None  # None in records of before it was kept


def halved(d1: float, d2: float, cause: str) -> Part:
    """The part of a cause whose size is halved twice, from the two differences of the result.

    >>> halved(3.0, 0.75, "time step")  # second order: 4 in all
    Part(cause='time step', value=4.0, open=0.0, how='runs')
    >>> halved(3.0, -1.0, "time step")
    Part(cause='time step', value=2.0, open=1.0, how='runs')
    """
    if d2 and FALLS <= d1 / d2 <= SLOWEST:
        return Part(cause, d1 + d2 + d2 / (d1 / d2 - 1.0))
    return Part(cause, d1 + d2, abs(d2))


def sampled(coarse: float, phases: Sequence[Sequence[float]]) -> Part:
    """The part of the sampling: from `coarse`, as the run is read, to what readings of 1, 2 and 4 spacings tend to.

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
    """The parts, with what they leave of the difference."""
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
