"""The child process that runs MuJoCo, seen from outside: its task, and the history that it leaves."""

import json

from vmharness.backends._translation import child
from vmharness.backends.mujoco.mjcf import document
from vmharness.backends.mujoco.step import step
from vmharness.backends.mujoco.translate import model_of, task
from vmharness.backends.protocol import Job, Output
from vmharness.deck import DeckError


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
    return child.run("vmharness.backends.mujoco.child", job.folder, what["channels"], missing)
