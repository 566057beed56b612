"""Cases solved in worker processes and judged; whatever one does, or a solver, does not stop the others."""

import time
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, closing
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from vmharness.execution.call import Caller, here
from vmharness.execution.folders import WorkFolders
from vmharness.execution.message import Began, Done, Lost, Message, Raised
from vmharness.execution.pool import Pool
from vmharness.execution.worker import Report, Work
from vmharness.suite.check import changed_values
from vmharness.suite.outcome import Outcome, Status

if TYPE_CHECKING:
    from pathlib import Path

    from vmharness.case import Case
    from vmharness.result import Solution

VERDICTS = {
    "pass": Status.PASS,
    "fail": Status.FAIL,
    "error": Status.UNJUDGED,
    "not representable": Status.UNREPRESENTABLE,
}


def solving(solver: str) -> Work:
    """In a worker: import the solver; what it makes of a case's deck, in a work folder, is the work."""
    from vmharness.backends import BackendError, calls
    from vmharness.solve import solve

    try:
        chosen = calls.solver(solver)
        calls.get_ready(solver)
    except BackendError as error:
        missing = _nothing(solver, str(error))
        return lambda task, progress: missing

    def work(task: "tuple[Case, Path | None]", progress: Report) -> "Solution":
        try:
            return solve(task[0], chosen, progress, task[1])
        except BackendError as error:
            return _nothing(solver, str(error))

    return work


def judged(
    pool: Pool, cases: Sequence["Case"], solver: str, timeout: float, call: Caller = here
) -> Iterator[tuple[int, Message | Outcome]]:
    """Yield (number of the case, Began or Progress or its Outcome), each outcome as soon as it is known.

    A case is judged by a `call`, which may have a time limit of its own.
    """
    began: dict[int, float] = {}
    with ExitStack() as stack:
        folders = stack.enter_context(WorkFolders())  # left last, when nothing is written there any more
        tasks = [(case, folders.folder(number)) for number, case in enumerate(cases)]
        for number, message in stack.enter_context(closing(pool.each(tasks, timeout))):
            case, closed = cases[number], partial(folders.close, number)
            match message:
                case Began():
                    began[number] = time.perf_counter()
                    yield number, message
                case Done(solution):
                    yield number, _outcome(call, case, solution, closed, time.perf_counter() - began[number])
                case Lost(reason):
                    nothing = _nothing(solver, reason)
                    yield number, _outcome(call, case, nothing, closed, time.perf_counter() - began[number])
                case Raised(error, trace):
                    yield number, Outcome(case.id, Status.DEFECT, closed(error), traceback=trace)
                case _:
                    yield number, message


def _outcome(
    call: Caller, case: "Case", solution: "Solution", closed: Callable[[str], str], seconds: float
) -> Outcome:
    """The outcome of a case; `closed` adds to a failure where the files of the run are."""
    try:
        solution = replace(solution, failure=closed(solution.failure))
    except Exception as error:  # of the harness: this is no solution
        return _defect(case, f"{type(error).__name__}: {error}", traceback.format_exc())
    match call(partial(judge, case, solution, seconds)):
        case Done(outcome):
            found: Outcome = outcome
            return found
        case Lost(reason):
            return Outcome(case.id, Status.UNJUDGED, f"could not be judged: {reason}")
        case Raised(error=what, traceback=trace):
            return _defect(case, what, trace)


def judge(case: "Case", solution: "Solution", seconds: float) -> Outcome:
    """What is to be said of a case whose solver gave `solution` after `seconds`."""
    from vmharness import run

    judged = replace(run.judge(case, solution), seconds=seconds)
    changed = changed_values(case)
    status = VERDICTS[judged.verdict]
    if not changed or status is Status.UNJUDGED:
        return Outcome(case.id, status, judged.reason, judged)
    if status is Status.PASS:  # of another problem than that of the theory
        return Outcome(case.id, Status.BROKEN, "; ".join(changed))
    return Outcome(case.id, status, "; ".join(changed), judged)


def judge_files(
    case: "Case", files: Sequence["Path"], columns: Mapping[str, str], solver: str = ""
) -> Outcome:
    """What is to be said of a case by result files that a solver has written elsewhere; see `collect`."""
    from vmharness.case import CaseError
    from vmharness.collect import collect
    from vmharness.deck import DeckError

    began = time.perf_counter()
    try:
        solution = collect(case, files, columns)
    except (CaseError, DeckError) as error:
        return Outcome(case.id, Status.BROKEN, str(error))
    return judge(case, replace(solution, solver=solver or solution.solver), time.perf_counter() - began)


def _defect(case: "Case", error: str, trace: str) -> Outcome:
    return Outcome(case.id, Status.DEFECT, error, traceback=trace)


def _nothing(solver: str, reason: str) -> "Solution":
    from vmharness.result import Solution

    return Solution(solver, None, reason)
