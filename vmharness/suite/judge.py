"""Cases solved in worker processes and judged here; nothing that a solver does takes the harness down."""

import time
import traceback
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from vmharness.execution.message import Began, Done, Lost, Message, Raised
from vmharness.execution.pool import Pool
from vmharness.execution.worker import Work
from vmharness.suite.outcome import Outcome, Status

if TYPE_CHECKING:
    from vmharness.case import Case
    from vmharness.result import Solution

VERDICTS = {"pass": Status.PASS, "fail": Status.FAIL, "error": Status.UNJUDGED}


def solving(solver: str) -> Work:
    """In a worker: import the solver; what it makes of a case's deck is the work."""
    from vmharness.backends import backend

    return backend(solver).solve


def judged(
    pool: Pool, cases: Sequence["Case"], solver: str, timeout: float
) -> Iterator[tuple[int, Message | Outcome]]:
    """Yield (number of the case, Began or Progress or its Outcome), each outcome as soon as it is known."""
    began: dict[int, float] = {}
    for number, message in pool.each(cases, timeout):
        case = cases[number]
        match message:
            case Began():
                began[number] = time.perf_counter()
                yield number, message
            case Done(solution):
                yield number, judge(case, solution, began[number])
            case Lost(reason):
                yield number, judge(case, _nothing(solver, reason), began[number])
            case Raised(error, trace):
                yield number, Outcome(case.id, Status.DEFECT, error, traceback=trace)
            case _:
                yield number, message


def judge(case: "Case", solution: "Solution", began: float) -> Outcome:
    """What is to be said of a case whose solver gave `solution`."""
    from vmharness import run

    try:
        judged = replace(run.judge(case, solution), seconds=time.perf_counter() - began)
    except Exception as error:  # of the harness: the solver is done
        return Outcome(
            case.id, Status.DEFECT, f"{type(error).__name__}: {error}", traceback=traceback.format_exc()
        )
    return Outcome(case.id, VERDICTS[judged.verdict], judged.reason, judged)


def _nothing(solver: str, reason: str) -> "Solution":
    from vmharness.result import Solution

    return Solution(solver, None, reason)
