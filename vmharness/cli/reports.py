"""Reports of a run; an error in one is reported and does not stop the others."""

import traceback
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from vmharness.cli.say import write_file
from vmharness.suite.outcome import Status, Unwritten

if TYPE_CHECKING:
    from vmharness.export import Run
    from vmharness.result import CaseRun

NEEDED = (
    "vmharness.run",  # to judge
    "scipy.interpolate",
    "matplotlib.backends.backend_svg",
    "vmharness.report.page",
    "jinja2",
)


def write_page(run: "CaseRun", root: Path, name: str, indexed: bool) -> None:
    """Write the pages of a case to `root`/`name`; `indexed`: an index follows."""
    from vmharness import report

    report.write_case(replace(run, case=replace(run.case, id=name)), root, indexed=indexed)


def write_unjudged(id: str, reason: str, root: Path, indexed: bool) -> None:
    """Write to `root`/`id` that the case could not be judged; `indexed`: an index follows."""
    from vmharness import report
    from vmharness.result import Unrun

    report.write_unjudged(Unrun(id, reason), root, indexed)


def write_export(format: str, run: "Run", path: Path) -> None:
    """Write the results of a run in an export format."""
    from vmharness import report

    write_file(path, report.render(format, run))


def attempted(what: str, write: Callable[[], object]) -> list[Unwritten]:
    """Call `write`; returns the file that is not written if that fails, else nothing."""
    try:
        write()
    except OSError as error:
        return [Unwritten(what, Status.UNWRITTEN, str(error))]
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
        return [Unwritten(what, Status.DEFECT, reason, traceback.format_exc())]
    return []
