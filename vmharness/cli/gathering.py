"""Variants of a study run with a progress bar, and the record of the study written."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from vmharness.cli.options import How
from vmharness.cli.progress import study_bar
from vmharness.cli.say import complain, say, write_file

if TYPE_CHECKING:
    from vmharness.execution.pool import Pool
    from vmharness.studies.gather import Plant
    from vmharness.studies.measured import Measured
    from vmharness.studies.variant import Variant


def gathered(
    variants: Sequence["Variant"],
    how: How,
    what: str,
    plant: "Plant | None" = None,
    workers: "Pool | None" = None,
) -> list["Measured"]:
    """The outcome of every variant, in order; a terminal shows the progress of the study `what`.

    An interrupt is passed on after a message: outcomes so far are kept.
    """
    from vmharness.execution.message import Progress
    from vmharness.studies.gather import gather
    from vmharness.studies.measured import Measured

    found: dict[int, Measured] = {}
    try:
        with study_bar(what, len(variants)) as bar:
            for number, event in gather(variants, how.jobs, how.timeout, how.solver, plant, workers):
                if isinstance(event, Measured):
                    found[number] = event
                    bar(number, 1.0)
                elif isinstance(event, Progress):
                    bar(number, event.fraction)
    except KeyboardInterrupt:
        complain(f"{len(found)} of {len(variants)} runs are done and kept; repeat the command to continue")
        raise
    cached = sum(outcome.cached for outcome in found.values())
    say(f"{what}: {len(variants)} runs" + (f", {cached} of them from cache" if cached else ""))
    return [found[number] for number in range(len(variants))]


def write_record(root: Path, case: str, name: str, record: Any, json: Path | None) -> None:
    """Write the record of a study beside the page of the case, and to the file of --json."""
    from vmharness.report import records

    path = records.write(root, case, name, record)
    if json is not None:
        write_file(json, path.read_text(encoding="utf-8"))
    say(f"{path} is written; `vm run {case}` adds it to the page")
