"""Checks of a case that need no run."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from vmharness.suite.select import Entry, read_case

if TYPE_CHECKING:
    from vmharness.case import Case


@dataclass
class Review:
    """Sentences on errors of a case, and on doubtful points."""

    wrong: list[str] = field(default_factory=list)
    doubtful: list[str] = field(default_factory=list)


def check(folder: Path, errors: Mapping[str, float] | None = None, solver: str = "builtin") -> Review:
    """Read the case, its prose and its deck, let the solver review it, review tolerances, faults and published values.

    `errors`: how far its results were from their targets when last run, as fractions, by key.
    """
    from vmharness.case import CaseError, tolerance
    from vmharness.report import prose
    from vmharness.review.published import unexplained

    review = Review()
    try:
        case = read_case(Entry(folder))
        review.wrong += refused(case)
        review.wrong += changed_values(case)
        review.wrong += prose.review(case)
        _, loose = tolerance.review(case)
        review.doubtful += [*loose, *tolerance.review_measured(case, errors or {}), *unexplained(case)]
        review.wrong += _solver(case, solver)
    except CaseError as error:
        review.wrong.append(str(error))
    except Exception as error:  # whatever one case does is its own outcome
        review.wrong.append(f"{folder.name}: cannot be checked: {type(error).__name__}: {error}")
    return review


def accepted(entry: Entry) -> "Case":
    """Read a case; raises CaseError for everything that `check` finds wrong without a solver, but for two things.

    A deck with changed values runs, and must fail the case. A page shows of the prose what it can.
    """
    from vmharness.case import CaseError

    case = read_case(entry)
    if wrong := refused(case):
        raise CaseError("; ".join(wrong))
    return case


def refused(case: "Case") -> list[str]:
    """Reasons why no run of the case can be judged, whatever the solver computes."""
    from vmharness.case import tolerance
    from vmharness.case.deck import read_deck
    from vmharness.deck import DeckError
    from vmharness.review.own_input import own_input
    from vmharness.review.run_length import intervals, outside_run
    from vmharness.studies.faults import declared as faults

    tight, _ = tolerance.review(case)
    wrong = [*tight, *faults.review(case)]
    with suppress(DeckError):  # the solver says so
        deck = read_deck(case)
        wrong += [*own_input(case, deck), *outside_run(case, deck), *intervals(case, deck)]
        try:
            read_deck(_with_parameters_set(case))
        except DeckError as error:
            wrong.append(str(error))
    return wrong


def changed_values(case: "Case") -> list[str]:
    """Sentences on parameters of the deck that are not those of the case; a run with them does not pass."""
    from vmharness.case.deck import read_deck
    from vmharness.deck import DeckError
    from vmharness.review.deck_values import disagreements

    with suppress(DeckError):  # the solver says so
        return disagreements(case, read_deck(case))
    return []


def _solver(case: "Case", solver: str) -> list[str]:
    """Reasons why the solver cannot run the deck."""
    from vmharness.backends import BackendError, calls
    from vmharness.case.deck import read_deck
    from vmharness.deck import DeckError
    from vmharness.deck.finding import unsupported

    try:
        return list(map(str, unsupported(calls.solver(solver).review(read_deck(case), case.file.channels))))
    except (DeckError, BackendError) as error:
        return [str(error)]


def _with_parameters_set(case: "Case") -> "Case":
    """The case with all its parameters set in the deck; the deck must have each of them as *PARAMETER."""
    values = {name: case.evaluate(f"parameter {name}") for name in case.file.deck.parameters}
    return replace(case, overrides=values)
