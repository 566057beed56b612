"""The child process that runs OpenSees, seen from outside: its task, and the history that it leaves."""

import json

from vmharness.backends._translation import child
from vmharness.backends.opensees.translate import model_of, task
from vmharness.backends.protocol import Job, Output
from vmharness.deck import DeckError


def run(job: Job) -> Output:
    """Write the task, run the child, read the history; raises DeckError, and ProgramError if OpenSees ends early."""
    try:
        model = model_of(job.deck)
    except DeckError as error:
        return Output(None, unrepresentable=str(error))
    what, missing = task(model, job.channels)
    (job.folder / "model.json").write_text(json.dumps(what))
    return child.run("vmharness.backends.opensees.child", job.folder, what["channels"], missing)
