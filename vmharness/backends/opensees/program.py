"""The child process that runs OpenSees, seen from outside: its task, and the history that it leaves."""

import json
import sys
import time

import numpy as np

from vmharness.backends.opensees.translate import model_of, task
from vmharness.backends.protocol import Job, Output
from vmharness.deck import DeckError
from vmharness.execution import program
from vmharness.history import History

ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def run(job: Job) -> Output:
    """Write the task, run the child, read the history; raises DeckError, and ProgramError if OpenSees ends early."""
    try:
        model = model_of(job.deck)
    except DeckError as error:
        return Output(None, unrepresentable=str(error))
    what, missing = task(model, job.channels)
    (job.folder / "model.json").write_text(json.dumps(what))
    began = time.perf_counter()
    program.run([sys.executable, "-m", "vmharness.backends.opensees.child"], job.folder, ONE_THREAD)
    seconds = time.perf_counter() - began
    facts = json.loads((job.folder / "facts.json").read_text())
    table = np.load(job.folder / "history.npy")
    columns = {name: table[:, 1 + i] for i, name in enumerate(what["channels"])}
    return Output(
        History(table[:, 0], columns),
        facts.pop("failure"),
        facts=facts,
        cycles=table.shape[0] - 1,
        seconds=seconds,
        unreported=missing,
    )
