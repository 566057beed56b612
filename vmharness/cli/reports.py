"""Reports of a run, written so that what goes wrong with one is said, and stops nothing else."""

import contextlib
import traceback
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING

from vmharness.suite.outcome import Status, Unwritten

if TYPE_CHECKING:
    from vmharness.result import CaseRun, Unrun

NEEDED = (
    "vmharness.run",
    "scipy.interpolate",
    "matplotlib.backends.backend_svg",
    "vmharness.report.page",
    "jinja2",
)


def get_ready() -> None:
    """Import what writing reports needs, beside the solver: that takes about as long as a short case."""

    def load() -> None:
        with contextlib.suppress(Exception):  # is imported again, and complained about, where it is used
            for module in NEEDED:
                import_module(module)

    Thread(target=load, daemon=True).start()


def write_page(run: "CaseRun", root: Path, name: str, indexed: bool) -> None:
    """Write the pages of a case to `root`/`name`; `indexed` if an index will follow."""
    from vmharness import report

    report.write_case(replace(run, case=replace(run.case, id=name)), root, indexed=indexed)


def write_file(format: str, runs: list["CaseRun"], unrun: Sequence["Unrun"], path: Path) -> None:
    """Write all runs, and the cases without one, in a format for machines."""
    from vmharness import report
    from vmharness.execution import atomic

    atomic.write(path, report.render(format, runs, unrun))


def attempted(what: str, write: Callable[[], object]) -> list[Unwritten]:
    """Do `write`; nothing, or where that fails what is then not written."""
    try:
        write()
    except OSError as error:
        return [Unwritten(what, Status.UNWRITTEN, str(error))]
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
        return [Unwritten(what, Status.DEFECT, reason, traceback.format_exc())]
    return []
