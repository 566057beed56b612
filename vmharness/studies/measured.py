"""Outcome of a variant of a case, small enough to send between processes and to keep on disk."""

import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from vmharness.round_off import ROUND_OFF, largest

if TYPE_CHECKING:
    from vmharness.history import History
    from vmharness.result import CaseRun, Row


@dataclass(frozen=True)
class Value:
    """A result: target and computed value in its unit, and the share of the tolerance that it uses."""

    target: float
    value: float | None  # None where there is none, or it is not finite
    share: float | None
    verdict: str
    reason: str = ""

    @property
    def error(self) -> float | None:
        """(value - target)/target, a fraction; None without a value, or for a target of zero."""
        return self.value / self.target - 1.0 if self.value is not None and self.target else None

    @property
    def is_round_off(self) -> bool:
        """Whether the error is only round-off."""
        return self.error is not None and abs(self.error) <= ROUND_OFF


@dataclass(frozen=True)
class Measured:
    """The outcome of a variant."""

    results: dict[str, Value] = field(default_factory=dict)  # by key, in the case's order
    events: dict[str, float | None] = field(default_factory=dict)  # times, consistent units
    failure: str = ""  # why the run ended early, or never began
    cycles: int = 0
    seconds: float = 0.0
    history_sha256: str = ""  # equal where every channel is the same to the last bit
    thinned: dict[int, dict[str, list[float | None]]] = field(default_factory=dict)  # by stride: see phases()
    solver: str = ""  # name and version; empty where a run was lost
    cached: bool = False  # found on disk, and not run
    lost: bool = False  # the run was ended from outside: nothing can be said of it

    @property
    def passed(self) -> bool:
        """Every result is within its tolerance."""
        return (
            not self.failure
            and bool(self.results)
            and all(value.verdict == "pass" for value in self.results.values())
        )

    @property
    def worst(self) -> tuple[str, float] | None:
        """Key and share of the result that uses most of its tolerance, of several the first.

        One without a value uses more than any.
        """
        shares = {
            key: math.inf if value.share is None else value.share for key, value in self.results.items()
        }
        return largest(shares.items(), lambda item: item[1]) if shares else None


def measured(run: "CaseRun", strides: Sequence[int] = ()) -> Measured:
    """The outcome of a run, with its results read from every n-th sample for each n of `strides`."""
    from vmharness.studies.thinning import phases

    solution = run.solution
    fine = solution.history if solution.history is not None and not solution.failure else None
    return Measured(
        results={row.key: _value(row) for row in run.rows},
        events={name: None if isinstance(event, str) else event.time for name, event in run.events.items()},
        failure=solution.failure,
        lost=solution.lost,
        cycles=solution.cycles,
        seconds=run.seconds,
        history_sha256=_sha256(solution.history) if solution.history else "",
        solver=solution.solver,
        thinned={n: phases(run.case, fine, n) for n in strides} if fine else {},
    )


def _value(row: "Row") -> Value:
    c = row.comparison
    value = c.value if math.isfinite(c.value) else None
    return Value(c.target, value, c.share, str(c.verdict), c.reason)


def _sha256(history: "History") -> str:
    digest = hashlib.sha256(history.time.tobytes())
    for name, values in history.channels.items():
        digest.update(name.encode())
        digest.update(values.tobytes())
    return digest.hexdigest()
