"""The manual: pages of cases, their index, and exports of the results."""

from collections.abc import Sequence
from pathlib import Path

from vmharness import plugins
from vmharness.execution import atomic
from vmharness.export import Run
from vmharness.result import CaseRun, Unrun

PAGES, FILES = "vmharness.report.formats", "vmharness.report.exports"


def write_case(run: CaseRun, folder: Path, volatile: bool = True, indexed: bool = False) -> list[Path]:
    """Write the page of a case into `folder`/<id> in every format of the manual, with its figures.

    A deck that is not the one of the case's folder is written, too. All is rendered before any of it is
    written. What varies from run to run (machine, versions, date, seconds) is in the HTML alone, and left out of it
    too unless `volatile`. The page leads back to the index where there is one, or will be (`indexed`). Raises OSError.
    """
    from vmharness.report.page import page
    from vmharness.report.prose import pictures
    from vmharness.report.records import studies

    indexed = indexed or all((folder / form.FILE).is_file() for form in plugins.modules(PAGES))
    to = folder / run.case.id
    content = page(run, volatile, indexed, studies(run.case, to))
    texts = {to / form.FILE: form.case(content, to) for form in plugins.modules(PAGES)}
    studied = [figure for each in (*content.published.values(), *content.studies) for figure in each.figures]
    for figure in filter(None, [content.model, *content.histories, *studied]):
        texts[to / f"{figure.name}.svg"] = figure.svg
    for name, picture in pictures(run.case).items():
        if to / name in texts:
            raise FileExistsError(
                f"{name}: the page has a figure of this name; rename the drawing of the case"
            )
        texts[to / name] = picture.read_text(encoding="utf-8")
    if run.solution.resolved_deck:
        texts[to / run.case.deck_name] = run.solution.resolved_deck
    return [atomic.write(path, text) for path, text in texts.items()]


def write_unjudged(case: Unrun, folder: Path, indexed: bool = False) -> list[Path]:
    """Write the page of a case that could not be judged over that of an earlier run; raises OSError."""
    to = folder / case.id
    texts = {to / form.FILE: form.unjudged(case, indexed) for form in plugins.modules(PAGES)}
    return [atomic.write(path, text) for path, text in texts.items()]


def write_index(runs: list[CaseRun], folder: Path, unrun: Sequence[Unrun] = ()) -> list[Path]:
    """Write the index of `runs` and of cases without a run into `folder`, in every format; raises OSError."""
    from vmharness.report.index import index
    from vmharness.report.records import summaries
    from vmharness.report.sections import faults

    studied = {run.case.id: summaries(run.case, folder / run.case.id) for run in runs}
    forms = plugins.modules(PAGES)
    pages = [case.id for case in unrun if all((folder / case.id / form.FILE).is_file() for form in forms)]
    content = index(runs, unrun, studied, faults.manual([run.case for run in runs], folder), pages)
    texts = {folder / form.FILE: form.index(content) for form in forms}
    return [atomic.write(path, text) for path, text in texts.items()]


def formats() -> list[str]:
    """The names of the export formats."""
    return plugins.names(FILES)


def render(name: str, run: Run) -> str:
    """The results of a run in the export format `name`."""
    return str(plugins.module(FILES, name).render(run))
