"""The child process that runs MuJoCo, seen from outside: its task, and the history that it leaves."""

import json
import sys
import time

import numpy as np

from vmharness.backends.mujoco.mjcf import document
from vmharness.backends.mujoco.step import step
from vmharness.backends.mujoco.translate import model_of, task
from vmharness.backends.protocol import Job, Output
from vmharness.deck import DeckError
from vmharness.execution import program
from vmharness.history import History

ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def run(job: Job) -> Output:
    """Write model and task, run the child, read the history; raises ProgramError if MuJoCo ends early."""
    try:
        model = model_of(job.deck)
        text = document(model, step(model))
    except DeckError as error:
        return Output(None, unrepresentable=str(error))
    what, missing = task(model, job.channels)
    (job.folder / "model.xml").write_text(text, encoding="utf-8")
    (job.folder / "task.json").write_text(json.dumps(what), encoding="utf-8")
    began = time.perf_counter()
    program.run([sys.executable, "-m", "vmharness.backends.mujoco.child"], job.folder, ONE_THREAD)
    seconds = time.perf_counter() - began
    facts = json.loads((job.folder / "facts.json").read_text(encoding="utf-8"))
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
