"""A run of the built-in solver: the model of a deck, stepped to its end, with its channels at every t_n."""

import time
from array import array
from collections.abc import Callable, Mapping

import numpy as np

from vmharness.backends.builtin.channels import probe_of
from vmharness.backends.protocol import Job, Output
from vmharness.explicit.build import build
from vmharness.explicit.contact.limits import limits_reached
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes import Probe, ProbeError
from vmharness.explicit.supported import notes
from vmharness.explicit.watch import Watch
from vmharness.history import History

PROGRESS_EVERY = 1000  # cycles


def run(job: Job) -> Output:
    """Build the model and record the channels every cycle; raises DeckError for what cannot be built."""
    model = build(job.deck)
    try:
        probes = {name: probe_of(model, channel) for name, channel in job.channels.items()}
    except ProbeError as error:
        return Output(None, str(error))
    studied = any(c.energy == "hourglass" and c.part is not None for c in job.channels.values())
    history, failure, seconds = record(model, probes, job.progress, Watch(model, hourglass=not studied))
    said = tuple(notes(model.idle, model.facts))
    samples = history if len(history.time) else None  # none where the run ends in cycle 0
    return Output(samples, failure, _facts(model, history), model.state.cycle, seconds, said)


def record(
    model: Model,
    probes: Mapping[str, Probe],
    progress: Callable[[float], None] | None = None,
    watch: Watch | None = None,
) -> tuple[History, str, float]:
    """Step the model to its end and keep what the probes show at every t_n.

    Returns the history so far, why it ended early or cannot be judged, and the seconds that the loop took.
    """
    times = array("d")
    columns = {name: array("d") for name in probes}
    take = [(column.append, probes[name]) for name, column in columns.items()]
    watch, failure = watch or Watch(model), ""
    began = time.perf_counter()
    try:
        for state in steps(model, watch):
            times.append(state.t)
            for append, value in take:
                append(value())
            if progress is not None and state.cycle % PROGRESS_EVERY == 0:
                progress(state.t / model.end_time)
        failure = watch.impossible()
    except SolverError as error:
        failure = str(error)
    seconds = time.perf_counter() - began
    return (
        History(np.array(times), {name: np.array(column) for name, column in columns.items()}),
        failure,
        seconds,
    )


def _facts(model: Model, history: History) -> dict[str, str]:
    steps_taken = np.diff(history.time)
    facts = {"Nodes": str(model.node_count), "Cycles": str(model.state.cycle)}
    if steps_taken.size:
        facts["Time step"] = f"{steps_taken.min():.6g} to {steps_taken.max():.6g}, {model.controlling()}"
    return facts | model.facts | limits_reached(model)
