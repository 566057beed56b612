"""ccx, run in the work folder: its input, its end, and the history that it leaves."""

import time
from collections.abc import Mapping

import numpy as np

from vmharness.backends._translation.review import planned
from vmharness.backends.calculix import PROGRAM
from vmharness.backends.calculix.channels import plan
from vmharness.backends.calculix.clock import Clock, clock
from vmharness.backends.calculix.dat import Array, DatError, read
from vmharness.backends.calculix.masses import free
from vmharness.backends.calculix.model import Model
from vmharness.backends.calculix.plan import Plan
from vmharness.backends.calculix.translate import model_of, steps, written
from vmharness.backends.protocol import Job, Output
from vmharness.deck import DeckError
from vmharness.execution import program
from vmharness.execution.program import ProgramError
from vmharness.history import History

ONE_THREAD = {"OMP_NUM_THREADS": "1"}
NAME = "job"
SCHEME = "Newmark, gamma = 1/2, beta = 1/4 (*DYNAMIC, DIRECT, ALPHA=0), large displacements"


def run(job: Job) -> Output:
    """Write the input, run ccx, read what it has printed.

    Raises ProgramError if ccx fails, also where its exit code does not say so.
    """
    try:
        model = model_of(job.deck)
    except DeckError as error:
        return Output(None, unrepresentable=str(error))
    wanted, missing = planned(model, job.channels, plan)
    ticks = clock(model, steps(model))
    text = "\n".join(written(model, wanted.values(), ticks))
    (job.folder / f"{NAME}.inp").write_text(f"{text}\n", encoding="ascii")
    began = time.perf_counter()
    printed = program.run([PROGRAM, NAME], job.folder, ONE_THREAD)
    seconds = time.perf_counter() - began
    try:
        if "*ERROR" in printed:
            raise DatError("it reports an error")
        found = read(job.folder / f"{NAME}.dat", ticks.times + ticks.before) if wanted else {}
    except DatError as error:
        raise ProgramError(
            f"{PROGRAM} ended without a complete result: {error}{program.tail(printed)}"
        ) from None
    return Output(
        _history(ticks.times, {name: one.value(found) for name, one in wanted.items()}, wanted),
        facts=_facts(model, ticks),
        cycles=ticks.count,
        seconds=seconds,
        unreported=missing,
    )


def _facts(model: Model, ticks: Clock) -> dict[str, str]:
    facts = {
        "Integrator": SCHEME,
        "Time step": f"{ticks.dt:.6g}, constant",
        "Precision": "seven digits, as printed in job.dat",
    }
    if ticks.before:
        facts["Start"] = "half a step before the loads, which would kick solids C3D8I"
    if free(model):
        facts["Free masses"] = "on springs too soft to act, without which ccx does not move them"
    return facts


def _history(times: Array, values: Mapping[str, Array], wanted: Mapping[str, Plan]) -> History:
    """The channels from t = 0; those whose value is not known then, from the first step."""
    channels: dict[str, Array] = {}
    own: dict[str, Array] = {}
    for name, one in wanted.items():
        if one.start is None:
            own[name], channels[name] = times, values[name]
        else:
            channels[name] = np.concatenate([[one.start], values[name]])
    return History(np.concatenate([[0.0], times]), channels, own)
