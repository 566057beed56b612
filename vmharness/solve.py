"""Solve one case: read its deck, run the solver in a work folder, collect the solution."""

import time
from collections.abc import Callable
from pathlib import Path
from subprocess import SubprocessError
from tempfile import TemporaryDirectory

from vmharness.backends.protocol import Backend, Job, full_name
from vmharness.case import Case, CaseError
from vmharness.case.deck import read_deck
from vmharness.deck import DeckError, write_long
from vmharness.mesh.view import drawable
from vmharness.result import Solution

Progress = Callable[[float], None]


def solve(
    case: Case, backend: Backend, progress: Progress | None = None, folder: Path | None = None
) -> Solution:
    """The solution of the case's deck by the solver; errors of deck and solver are its `failure`.

    The solver runs in the empty `folder`, by default in a temporary one that is removed afterwards.
    """
    if folder is None:
        with TemporaryDirectory(prefix="vmharness-") as temporary:
            return solve(case, backend, progress, Path(temporary))
    began = time.perf_counter()
    found = backend.found()
    solver = full_name(backend, found)
    if found.missing:
        return Solution(solver, None, f"{backend.NAME} cannot run here: {found.missing}", lost=True)
    try:
        deck = read_deck(case)
        output = backend.solve(Job(deck, case.file.channels, folder, progress))
    except (CaseError, DeckError) as error:
        return Solution(solver, None, str(error))
    except SubprocessError as error:
        return Solution(solver, None, str(error), lost=True)
    if output.unrepresentable:
        return Solution(
            solver, None, unrepresentable=output.unrepresentable, files=deck.files, view=drawable(deck)
        )
    if output.history is None:
        return Solution(solver, None, output.failure or "the solver gave no history")
    return Solution(
        solver=solver,
        history=output.history,
        failure=output.failure,
        unreported=output.unreported,
        facts=output.facts,
        cycles=output.cycles,
        seconds=time.perf_counter() - began,
        seconds_loop=output.seconds,
        notes=(*deck.notes, *output.notes),
        files=deck.files,
        view=drawable(deck),
        resolved_deck=write_long(deck) if case.deck_parameters() else case.deck_source(),
    )
