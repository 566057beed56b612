"""Checks of a case that need no run."""

from collections.abc import Mapping
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
    """Read the case, its prose and its deck, let the solver review it, review tolerances and faults.

    `errors`: how far its results were from their targets when last run, as fractions, by key.
    """
    from vmharness.case import CaseError, tolerance
    from vmharness.report import prose
    from vmharness.studies.faults import declared as faults

    review = Review()
    try:
        case = read_case(Entry(folder))
        tight, review.doubtful = tolerance.review(case)
        review.wrong += tight
        review.doubtful += tolerance.review_measured(case, errors or {})
        review.wrong += faults.review(case)
        review.wrong += prose.review(case)
        review.wrong += _deck(case, solver)
    except CaseError as error:
        review.wrong.append(str(error))
    except Exception as error:  # whatever one case does is its own outcome
        review.wrong.append(f"{folder.name}: cannot be checked: {type(error).__name__}: {error}")
    return review


def _deck(case: "Case", solver: str) -> list[str]:
    """Reasons why the solver cannot run the deck."""
    from vmharness.backends import BackendError, calls
    from vmharness.case.deck import read_deck
    from vmharness.deck import DeckError
    from vmharness.deck.finding import unsupported

    wrong: list[str] = []
    try:
        wrong += map(str, unsupported(calls.solver(solver).review(read_deck(case), case.file.channels)))
        read_deck(_with_parameters_set(case))
    except (DeckError, BackendError) as error:
        wrong.append(str(error))
    return wrong


def _with_parameters_set(case: "Case") -> "Case":
    """The case with all its parameters set in the deck; the deck must have each of them as *PARAMETER."""
    values = {name: case.evaluate(f"parameter {name}") for name in case.file.deck.parameters}
    return replace(case, overrides=values)
