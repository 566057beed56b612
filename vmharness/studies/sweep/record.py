"""Record of a sweep: the share of its tolerance that each result uses over a region of the given data."""

import math
from dataclasses import dataclass

from vmharness.studies.maker import Maker


@dataclass(frozen=True)
class Worst:
    """The point at which a result uses the largest share of its tolerance."""

    key: str
    label: str
    share: float | None  # of its tolerance; None where there is no value
    error: float | None  # (value - target)/target
    at: dict[str, float]  # the data, each in its unit
    failed: int  # points at which it is out of tolerance


@dataclass(frozen=True)
class Failing:
    """A point that fails, the simplest point that fails, too, and the command that runs it."""

    at: dict[str, float]
    simpler: dict[str, float]
    why: str
    again: str


@dataclass(frozen=True)
class SweepRecord:
    """The record of `vm sweep`."""

    case: str
    case_sha256: str  # of its inputs
    how: str  # "Latin hypercube of 200 points, seed 0"
    ranges: dict[str, tuple[float, float]]  # in the unit of each datum
    units: dict[str, str]
    within: list[str]  # constraints, as sentences
    data: dict[str, list[float]]  # by name: of every point
    shares: dict[str, list[float | None]]  # by key of the result: at every point
    results: list[Worst]
    unjudged: dict[int, str]  # by number of the point: why it has no verdict
    failing: Failing | None  # the worst of them
    made_by: Maker | None = None  # None in records of before it was kept

    @property
    def points(self) -> int:
        """The number of points."""
        return len(next(iter(self.data.values())))

    @property
    def failed(self) -> list[int]:
        """Numbers of the points at which a result is out of tolerance."""
        return [i for i in range(self.points) if i not in self.unjudged and not worst_share(self, i) <= 1.0]


def worst_share(found: SweepRecord, i: int) -> float:
    """The largest share of a tolerance at the point `i`; infinite where a result has no value."""
    shares = [shares[i] for shares in found.shares.values()]
    return max(math.inf if share is None else share for share in shares)
