"""Declared faults: changes of the deck alone that must fail the case."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from vmharness.case import Case, CaseError
from vmharness.case.format import RUN_LENGTH, Fault
from vmharness.case.settings import changed_value
from vmharness.case.tolerance import allowed_difference
from vmharness.formula import FormulaError, Unit
from vmharness.history import History, HistoryError
from vmharness.measure import find_event, value_at
from vmharness.round_off import AGREE, ROUND_OFF

SAMPLES = 1001  # of a curve of theory over the run


@dataclass(frozen=True)
class Move:
    """The change of a result by a fault, by theory."""

    percent: float | None  # of the target; None where that is zero
    tolerances: float  # change / allowed difference: a result cannot fail unless this is above 1


def in_deck(case: Case, datum: str) -> bool:
    """Whether a parameter of the deck, other than the end time, follows from a given datum."""
    deck = case.file.deck
    follow = [f"parameter {name}" for name, formula in deck.parameters.items() if formula != RUN_LENGTH]
    follow += [f"mesh {name}" for name in deck.mesh]
    return any(datum in case.origins(name) for name in follow)


def moves(case: Case, fault: Fault) -> Mapping[str, Move | None]:
    """The change of each result that must fail, by key: theory with the faulty data less theory with the sound data.

    The faulty run is read at the time, or the level, of the sound theory. If the fault changes that time, too, the
    theory of the channel over time is read there; the change is None if the case has no such theory. Raises CaseError
    if no parameter of the deck follows from the data, or if theory has no value for them.
    """
    faulty = case.with_given(faulty_data(case, fault))
    return {key: _move(case, faulty, key) for key in fault.must_fail}


def review(case: Case) -> list[str]:
    """Sentences on declared faults that are too small to make a result fail, or that its reading does not show."""
    wrong = []
    for number, fault in enumerate(case.file.faults, 1):
        place = f"[faults] {number} ({fault.text})"
        try:
            weak = {key: _weakness(case, fault, key, move) for key, move in moves(case, fault).items()}
        except CaseError as error:
            wrong.append(f"{place}: {error}")
            continue
        wrong += [f"{place}: {key} must fail, but {why}" for key, why in weak.items() if why]
    return wrong


def _weakness(case: Case, fault: Fault, key: str, move: Move | None) -> str:
    """Why a fault does not make a result fail, or nothing."""
    if move is not None and not move.tolerances > 1.0:
        return f"by theory it changes by only {move.tolerances:.2g} of its tolerance"
    event, channel = case.file.events[case.result(key).event], case.result(key).channel
    unknown = {event.of, channel} - {"time", *case.file.curves}
    if event.of and not unknown and _stays(case, case.with_given(faulty_data(case, fault)), key):
        return "where the curves of the faulty theory have its event, it has the sound value"
    if event.of and unknown and move is None and channel != "time":
        needed = " and ".join(sorted(unknown))
        return f"the level of its event moves with the fault: add [curves] of {needed} to tell what is read there"
    return ""


def faulty_data(case: Case, fault: Fault) -> dict[str, float]:
    """The changed data in consistent units; `Case.with_deck_of` writes them into the deck alone."""
    return {
        name: changed_value(case.given[name], change, case.units.factor(case.file.given[name].unit))
        for name, change in fault.change.items()
    }


def _stays(case: Case, faulty: Case, key: str) -> bool:
    """Whether a result has its sound value at the event that is found in the curves of the faulty theory."""
    result = case.result(key)
    names = {case.file.events[result.event].of, result.channel} - {"time"}
    time = np.linspace(0.0, max(_end(case), _end(faulty)), SAMPLES)
    try:
        with np.errstate(all="ignore"):  # a curve may overflow where nothing is read
            history = History(time, {name: faulty.curve(name, time) for name in names})
            event = find_event(case, result.event, history)
            value = np.nan if isinstance(event, str) else value_at(history, result.channel, event.time)
    except (FormulaError, HistoryError):
        return False
    return bool(abs(value - case.target(key)) <= AGREE * allowed_difference(case, key))


def _end(case: Case) -> float:
    """The end of the run by theory; without a line for it, twice the largest time that theory has."""
    dimension = Unit(case.file.units.time).dimension
    times = [value for name, value in case.values.items() if case.dimensions[name] == dimension]
    return case.theory.get(RUN_LENGTH, 2.0 * max(times, default=0.0))


def _move(case: Case, faulty: Case, key: str) -> Move | None:
    change = change_seen(case, faulty, key)
    if change is None:
        return None
    target, allowed = case.target(key), allowed_difference(case, key)
    share = abs(change) / allowed if allowed else float("inf") if change else 0.0
    return Move(100.0 * change / target if target else None, share)


def change_seen(case: Case, faulty: Case, key: str) -> float | None:
    """The change of the value that is read for a result if the deck has the data of `faulty`; consistent units.

    It is read at the time, or the level, of the sound theory; None if theory has no curve to read there.
    """
    result = case.result(key)
    at, level = f"at {result.event}", f"level {result.event}"
    if not _unmoved(case, faulty, level):
        return None
    if _unmoved(case, faulty, at):
        return faulty.target(key) - case.target(key)
    if result.channel not in case.file.curves:
        return None
    time = np.array([case.evaluate(at)])
    return float((faulty.curve(result.channel, time) - case.curve(result.channel, time))[0])


def _unmoved(case: Case, faulty: Case, formula: str) -> bool:
    """Whether a formula, if the case has it, has the same value for both data but for round-off."""
    if formula not in case.formulas:
        return True
    return math.isclose(case.evaluate(formula), faulty.evaluate(formula), rel_tol=ROUND_OFF)
