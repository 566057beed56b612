"""Run many variants in worker processes, and keep each outcome on disk: an interrupted study loses nothing."""

import contextlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, closing
from dataclasses import replace
from pathlib import Path

import msgspec

from vmharness.cache import root
from vmharness.execution.folders import WorkFolders
from vmharness.execution.message import Began, Done, Lost, Message, Progress, Raised
from vmharness.execution.pool import Pool
from vmharness.execution.worker import Report, Work
from vmharness.studies.measured import Measured, measured
from vmharness.studies.variant import Variant

Plant = Callable[[str], None]  # changes the solver by a named fault, before it is imported
Step = tuple[int, Began | Progress | Measured]


def gather(
    variants: Sequence[Variant],
    jobs: int = 1,
    timeout: float = 600.0,
    solver: str = "builtin",
    plant: Plant | None = None,
    workers: Pool | None = None,
) -> Iterator[Step]:
    """Yield (number of the variant, Began or Progress or Measured) until each variant is Measured, once each.

    Outcomes are written to disk at once and read from there, so an interrupted study continues where it ended. Equal
    variants run once. A crash or a time limit is a failure of that variant alone. Variants with a
    `fault` run in processes of their own, in which `plant(fault)` comes before the solver is imported.
    Those without one run in `workers`, as `pool` makes them, if they are given: to begin again and again costs seconds.
    """
    waiting: dict[str, list[int]] = {}
    for number, variant in enumerate(variants):
        key = variant.key(solver)
        if key not in waiting and (known := kept(key)) and _is_outcome(known, variant):
            yield number, known
        else:
            waiting.setdefault(key, []).append(number)
    for planted in (False, True):
        keys = [key for key, numbers in waiting.items() if bool(variants[numbers[0]].fault) == planted]
        if not keys:
            continue
        keys.sort(key=lambda key: variants[waiting[key][0]].fault)  # so that few processes serve each fault
        tasks = [variants[waiting[key][0]] for key in keys]
        arguments = [(solver, task.fault, plant if planted else None) for task in tasks]
        with ExitStack() as stack:
            own = None if planted else workers
            folders = stack.enter_context(WorkFolders())  # left last, when nothing is written there any more
            at_work = own or stack.enter_context(Pool(min(jobs, len(tasks)), serving, *arguments[0]))
            work = [(variant, folders.folder(task)) for task, variant in enumerate(tasks)]
            messages = stack.enter_context(closing(at_work.each(work, timeout, arguments)))
            for task, message in _outcomes(messages, keys, folders):
                for number in waiting[keys[task]]:
                    yield number, message


def pool(jobs: int, solver: str) -> Pool:
    """Workers for several calls of `gather`; a context."""
    return Pool(jobs, serving, solver, "", None)


def serving(solver: str, fault: str, plant: Plant | None) -> Work:
    """In a worker: plant the fault, import the solver; the work is to run a variant and to measure.

    Nothing of a case, a solver or a measurement may be imported before: a fault can lie in any of them.
    """
    if fault:
        if plant is None:
            raise ValueError(f"nothing plants the fault {fault}")
        plant(fault)
    from vmharness.backends import BackendError, calls
    from vmharness.run import run

    chosen = calls.solver(solver)
    calls.get_ready(solver)

    def work(task: tuple[Variant, Path], progress: Report) -> Measured:
        variant, folder = task
        try:
            return measured(run(variant.case, chosen, progress, folder), variant.strides)
        except BackendError as error:
            return Measured(failure=str(error), lost=True)

    return work


def _outcomes(
    messages: Iterator[tuple[int, Message]], keys: Sequence[str], folders: WorkFolders
) -> Iterator[Step]:
    """The messages of a pool, with what is done kept on disk; of the files of a run, nothing is."""
    for task, message in messages:
        if isinstance(message, Done | Lost | Raised):
            folders.close(task)
        match message:
            case Done(outcome):
                if not outcome.lost:
                    keep(keys[task], outcome)
                yield task, outcome
            case Lost(reason, outside):
                yield task, Measured(failure=reason, lost=outside)
            case Raised(error):
                yield task, Measured(failure=f"defect: {error}", lost=error.startswith("MemoryError"))
            case _:
                yield task, message


def kept_file(key: str) -> Path:
    """The file of the outcome of a key, beside the compiled kernels of the solver."""
    return root() / "runs" / key[:2] / f"{key[2:]}.json"


def kept(key: str) -> Measured | None:
    """The outcome that is kept for a key, marked as `cached`; None where there is no readable one."""
    try:
        return replace(msgspec.json.decode(kept_file(key).read_bytes(), type=Measured), cached=True)
    except (OSError, RecursionError, msgspec.MsgspecError):
        return None


def _is_outcome(found: Measured, variant: Variant) -> bool:
    """Whether a file held the outcome of the variant: a failure, or each result of the case."""
    keys = {result.key for result in variant.case.file.results}
    return bool(found.failure) or found.results.keys() == keys


def keep(key: str, outcome: Measured) -> None:
    """Write an outcome; a folder that cannot be written is no error."""
    from vmharness.execution import atomic

    with contextlib.suppress(OSError):
        atomic.write(kept_file(key), msgspec.json.encode(outcome).decode())
