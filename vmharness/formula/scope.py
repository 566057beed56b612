"""The values of the names of a formula, at one point or at many."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from vmharness.formula.error import FormulaError

Value: TypeAlias = Any  # np.float64 (np.bool_ for a condition), or an array (points,) of them

CALL = 1000  # numbers that numpy computes in the time of one call of it
MOST_WORK = 3 * 10**8  # numbers computed in one evaluation, which take about two seconds


@dataclass
class Work:
    """How many numbers an evaluation has computed; an operation counts as CALL numbers more."""

    done: int = 0

    def add(self, numbers: int) -> None:
        """Count one operation; raises FormulaError once MOST_WORK is exceeded."""
        self.done += CALL + numbers
        if self.done > MOST_WORK:
            raise FormulaError("the evaluation takes too long: sums or roots within each other are too many")


@dataclass(frozen=True)
class Scope:
    """Values of names, scalars or arrays (points,); the enclosing sums evaluate them `repeats` times."""

    values: Mapping[str, Value]
    repeats: int = 1
    work: Work = field(default_factory=Work)  # of the whole evaluation

    @cached_property
    def points(self) -> int | None:
        """Length of the arrays, None if there are none."""
        return next((value.size for value in self.values.values() if value.ndim), None)

    def where(self, mask: NDArray[np.bool_]) -> "Scope":
        """The scope of the points where `mask` (points,) holds."""
        chosen = {name: value[mask] if value.ndim else value for name, value in self.values.items()}
        return replace(self, values=chosen)


Branch: TypeAlias = Callable[[Scope], Value]


def choose(condition: Value, scope: Scope, then: Branch, other: Branch) -> Value:
    """`then` where the condition holds, `other` elsewhere; neither is evaluated at any other point."""
    if np.all(condition):
        return then(scope)
    if not np.any(condition):
        return other(scope)
    a, b = then(scope.where(condition)), other(scope.where(~condition))
    chosen = np.empty(condition.shape, dtype=np.asarray(a).dtype)
    chosen[condition], chosen[~condition] = a, b
    return chosen
