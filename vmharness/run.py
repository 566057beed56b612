"""One case through one solver: deck in, judged results out."""

import hashlib
from pathlib import Path

from vmharness.backends.protocol import Backend
from vmharness.case import Case
from vmharness.case.format import Result
from vmharness.case.tolerance import budget
from vmharness.compare import Comparison, Tolerance, Verdict, compare
from vmharness.events import Event
from vmharness.formula import Unit
from vmharness.history import History, HistoryError
from vmharness.measure import find_event, value_at, watched
from vmharness.reading import readings
from vmharness.result import CaseRun, Published, Row, Solution
from vmharness.solve import Progress, solve


def run(
    case: Case, backend: Backend, progress: Progress | None = None, folder: Path | None = None
) -> CaseRun:
    """Give the deck to the solver, measure what the theory predicts, compare.

    What a deck or a solver does wrong raises nothing: it is a run that could not be judged, with its reason.
    """
    return judge(case, solve(case, backend, progress, folder))


def judge(case: Case, solution: Solution) -> CaseRun:
    """Measure in the solution what the theory predicts, and compare."""
    events = {name: _event(case, name, solution) for name in case.file.events}
    rows = tuple(_row(case, result, solution, events[result.event]) for result in case.file.results)
    return CaseRun(
        case=case,
        solution=solution,
        rows=rows,
        events=events,
        readings=readings(case, solution.history) if solution.history and not solution.failure else {},
        deck_sha256=_sha256(solution.resolved_deck.encode() or case.deck_path.read_bytes()),
        case_sha256=case.sha256,
        seconds=solution.seconds,
    )


def _event(case: Case, name: str, solution: Solution) -> Event | str:
    """When the event happened, or why that cannot be said."""
    if solution.history is None or len(solution.history) < 3:
        return "the solver gave no history"
    return find_event(case, name, solution.history)


def _row(case: Case, result: Result, solution: Solution, event: Event | str) -> Row:
    factor = case.units.factor(Unit(result.unit))
    tolerance = Tolerance(result.tolerance.relative, result.tolerance.absolute)
    target = case.target(result.key) / factor
    absent = [
        name
        for name in (watched(case.file.events[result.event]), result.channel)
        if name in solution.unreported
    ]
    if solution.unrepresentable:
        comparison = _unjudged(target, tolerance, Verdict.UNREPRESENTABLE, solution.unrepresentable)
    elif absent:
        why = f"{absent[0]} {solution.unreported[absent[0]]}"
        comparison = _unjudged(target, tolerance, Verdict.UNREPORTED, why)
    elif isinstance(event, str) or solution.history is None:
        comparison = _missing(target, tolerance, str(event), solution)
    else:
        comparison = _compared(result, target, tolerance, factor, event, solution.history)
    return Row(
        key=result.key,
        label=result.label,
        event=case.file.events[result.event].title,
        unit=result.unit,
        comparison=comparison,
        uncertainty=event.uncertainty if isinstance(event, Event) else None,
        because=result.tolerance.because,
        budget=budget(case, result.key),
        published={
            column.name: Published(column.values[result.key], column.errors_percent.get(result.key))
            for column in case.published
            if result.key in column.values
        },
    )


def _compared(
    result: Result, target: float, tolerance: Tolerance, factor: float, event: Event, history: History
) -> Comparison:
    """The value at the event, compared; a channel that has no samples there cannot be judged."""
    try:
        value = value_at(history, result.channel, event.time) / factor
    except HistoryError as error:
        return _unjudged(target, tolerance, Verdict.ERROR, str(error))
    return compare(target, value, tolerance, _scale(history, result.channel) / factor)


def _missing(target: float, tolerance: Tolerance, why: str, solution: Solution) -> Comparison:
    """An event that did not happen fails its results; one that an unfinished run never reached cannot be judged."""
    if solution.unfinished:
        why = f"{why}; {solution.unfinished}"
    verdict = Verdict.ERROR if solution.failure or solution.unfinished else Verdict.FAIL
    return _unjudged(target, tolerance, verdict, why)


def _unjudged(target: float, tolerance: Tolerance, verdict: Verdict, why: str) -> Comparison:
    return Comparison(target, float("nan"), tolerance, None, None, None, verdict, why)


def _scale(history: History, channel: str) -> float:
    return float(abs(history[channel]).max())


def _sha256(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()
