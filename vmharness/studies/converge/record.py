"""Record of a refinement: each result on each level, its order, and the order that theory expects."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from vmharness.case import Case
from vmharness.formula import Unit
from vmharness.studies.converge.richardson import Kind, Richardson, richardson
from vmharness.studies.maker import Maker

ENOUGH = 0.1  # of the expected order: the observed one may be lower by this, or by its uncertainty


@dataclass(frozen=True)
class Level:
    """One run of the sequence: N, its size, and the data that were set, each in its unit."""

    number: float
    size: float
    data: dict[str, float]
    cycles: int
    failure: str = ""


@dataclass(frozen=True)
class Refined:
    """One result on all levels, in its unit."""

    key: str
    label: str
    unit: str
    target: float
    values: list[float | None]
    promised: float | None  # expected order; None if the case expects none
    found: Richardson
    inside: bool | None  # whether theory is within the extrapolated value +- GCI; None without a GCI

    @property
    def agrees(self) -> bool | None:
        """Whether the order is the expected one or higher, or the values are exact; None without an expected order."""
        if self.promised is None:
            return None
        if self.found.kind is Kind.EXACT:
            return True
        if self.found.order is None:
            return False
        below = max(self.found.uncertainty or 0.0, ENOUGH * self.promised)
        return self.found.order >= self.promised - below


@dataclass(frozen=True)
class ConvergeRecord:
    """The record of `vm converge`."""

    case: str
    case_sha256: str  # of its inputs
    refined: str
    size: str  # the formula
    unit: str  # of the size
    held: str
    because: str
    levels: list[Level]
    results: list[Refined]
    made_by: Maker | None = None  # None in records of before it was kept


def refined(case: Case, sizes: Sequence[float], values: Mapping[str, list[float | None]]) -> list[Refined]:
    """Each result with its `values` at the falling `sizes`."""
    plan = case.file.converge
    orders = plan.orders if plan else {}
    found = []
    for result in case.file.results:
        target = case.target(result.key) / case.units.factor(Unit(result.unit))
        promised, computed = orders.get(result.key), values[result.key]
        sequence = richardson(sizes, computed, promised)
        inside = None
        if sequence.extrapolated is not None and sequence.gci is not None:
            inside = abs(sequence.extrapolated - target) <= sequence.gci
        found.append(
            Refined(result.key, result.label, result.unit, target, computed, promised, sequence, inside)
        )
    return found
