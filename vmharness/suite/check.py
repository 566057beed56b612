"""A case checked as far as it can be without running it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vmharness.case import Case


@dataclass
class Review:
    """What is wrong with a case, and what one should look at; sentences."""

    wrong: list[str] = field(default_factory=list)
    doubtful: list[str] = field(default_factory=list)


def check(folder: Path, errors: Mapping[str, float] | None = None, solver: str = "builtin") -> Review:
    """Read the case, its prose and its deck, let the solver review it, review tolerances and faults.

    `errors`: how far its results were from their targets when last run, as fractions, by key.
    """
    from vmharness.case import CaseError, read, tolerance
    from vmharness.report import prose
    from vmharness.studies.faults import declared as faults

    review = Review()
    try:
        case = read(folder)
        tight, review.doubtful = tolerance.review(case)
        review.wrong += tight
        review.doubtful += tolerance.review_measured(case, errors or {})
        review.wrong += faults.review(case)
        review.wrong += prose.review(case)
        review.wrong += _deck(case, solver)
    except CaseError as error:
        review.wrong.append(str(error))
    return review


def _deck(case: "Case", solver: str) -> list[str]:
    """What keeps the solver from running the deck."""
    from vmharness.backends import BackendError, backend
    from vmharness.case.deck import read_deck
    from vmharness.deck import DeckError
    from vmharness.deck.finding import unsupported

    wrong: list[str] = []
    try:
        wrong += map(str, unsupported(backend(solver).review(read_deck(case), case.file.channels)))
        read_deck(_with_parameters_set(case))
    except (DeckError, BackendError) as error:
        wrong.append(str(error))
    return wrong


def _with_parameters_set(case: "Case") -> "Case":
    """The case with every parameter that data can set, set: the deck must have it, and as one that can be set."""
    values = {name: case.evaluate(f"parameter {name}") for name in case.file.deck.parameters}
    return replace(case, overrides=values)
