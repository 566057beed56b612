"""A child process that runs a solver's Python package in the work folder, and the history that it leaves.

It leaves history.npy, with the time and the channels as columns, and facts.json, with `failure` among the facts.
"""

import json
import sys
import time
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from vmharness.backends.protocol import Output
from vmharness.execution import program
from vmharness.history import History

ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def run(module: str, folder: Path, channels: Iterable[str], unreported: Mapping[str, str]) -> Output:
    """Run the module, and read what it leaves; raises ProgramError if it ends early."""
    began = time.perf_counter()
    program.run([sys.executable, "-m", module], folder, ONE_THREAD)
    seconds = time.perf_counter() - began
    facts = json.loads((folder / "facts.json").read_text(encoding="utf-8"))
    table = np.load(folder / "history.npy")
    columns = {name: table[:, 1 + i] for i, name in enumerate(channels)}
    return Output(
        History(table[:, 0], columns),
        facts.pop("failure"),
        facts=facts,
        cycles=table.shape[0] - 1,
        seconds=seconds,
        unreported=unreported,
    )
