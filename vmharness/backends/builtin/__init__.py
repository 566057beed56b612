"""The built-in explicit finite-element code."""

import time
from array import array
from collections.abc import Callable, Mapping

import numpy as np
from msgspec.structs import asdict
from numpy.typing import NDArray

from vmharness import __version__
from vmharness.backends.builtin.view import view_of
from vmharness.case import Case, CaseError
from vmharness.case.format import Channel
from vmharness.deck import Deck, DeckError, read, vocabulary, write_long
from vmharness.explicit.build import build
from vmharness.explicit.contact.limits import limits_reached
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes import Probe, ProbeError, probe
from vmharness.history import History
from vmharness.result import Solution

SOLVER = f"vmharness {__version__}"
Array = NDArray[np.float64]

PROGRESS_EVERY = 1000  # cycles


def read_deck(case: Case) -> Deck:
    """The case's deck, with its parameters replaced where the data were changed, or the one set in its place."""
    return read(
        case.folder / case.deck_name,
        vocabulary(),
        parameters=case.deck_parameters(),
        include_outside=case.file.deck.include_outside,
        text=case.deck_source(),
    )


def solve(case: Case, progress: Callable[[float], None] | None = None) -> Solution:
    """Run the deck and record the case's channels every cycle."""
    began = time.perf_counter()
    try:
        deck = read_deck(case)
        model = build(deck)
        probes = {name: probe_of(model, channel) for name, channel in case.file.channels.items()}
    except (CaseError, DeckError, ProbeError) as error:
        return Solution(SOLVER, None, str(error))
    view = view_of(deck, model)  # before the nodes move
    history, failure, seconds = record(model, probes, progress)
    return Solution(
        solver=SOLVER,
        history=history,
        failure=failure,
        facts=_facts(model, history),
        cycles=model.state.cycle,
        seconds=time.perf_counter() - began,
        seconds_loop=seconds,
        notes=tuple(deck.notes),
        files=deck.files,
        view=view,
        resolved_deck=write_long(deck) if case.deck_parameters() else case.deck_source(),
    )


def record(
    model: Model, probes: Mapping[str, Probe], progress: Callable[[float], None] | None = None
) -> tuple[History, str, float]:
    """Step the model to its end and keep what the probes show at every t_n.

    Returns the history so far, why it ended early if it did, and the seconds that the loop took.
    """
    times = array("d")
    columns = {name: array("d") for name in probes}
    take = [(column.append, probes[name]) for name, column in columns.items()]
    failure = ""
    began = time.perf_counter()
    try:
        for state in steps(model):
            times.append(state.t)
            for append, value in take:
                append(value())
            if progress is not None and state.cycle % PROGRESS_EVERY == 0:
                progress(state.t / model.end_time)
    except SolverError as error:
        failure = str(error)
    seconds = time.perf_counter() - began
    return (
        History(np.array(times), {name: np.array(column) for name, column in columns.items()}),
        failure,
        seconds,
    )


def probe_of(model: Model, channel: Channel) -> Probe:
    """What shows a channel of a case; raises ProbeError where the model has no such thing."""
    fields = {name: value for name, value in asdict(channel).items() if value is not None}
    del fields["text"]
    return probe(model, **fields)


def _facts(model: Model, history: History) -> dict[str, str]:
    steps_taken = np.diff(history.time)
    facts = {"Nodes": str(model.node_count), "Cycles": str(model.state.cycle)}
    if steps_taken.size:
        facts["Time step"] = f"{steps_taken.min():.6g} to {steps_taken.max():.6g}, {model.controlling()}"
    return facts | model.facts | limits_reached(model)
