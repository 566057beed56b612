"""The manual as Markdown for a code host; equal results give equal bytes."""

import os
from collections.abc import Callable
from pathlib import Path

from vmharness.report import equations, escape, number, wording
from vmharness.report.index import Index
from vmharness.report.page import Page
from vmharness.report.templates import render
from vmharness.result import CaseRun, Unrun

FILE = "README.md"


def case(page: Page, folder: Path) -> str:
    """The page of a case, in `folder` beside its figures."""
    return render(
        "case.md.j2",
        _filters(),
        page=page,
        run=page.run,
        file=page.run.case.file,
        inputs=_inputs(page.run, folder),
        theory=lambda line: equations.theory(line, page),
        datum=lambda datum: equations.datum(datum, "latex"),
        wording=wording,
    )


def _inputs(run: CaseRun, folder: Path) -> list[tuple[str, str]]:
    """Links to the input files; a deck other than that of the case is beside the page."""
    case = run.case
    deck = folder / case.deck_name if run.solution.resolved_deck else case.deck_path
    paths = {name: case.folder / name for name in case.input_files}
    return [(name, _relative(path, folder)) for name, path in {case.deck_name: deck, **paths}.items()]


def unjudged(case: Unrun, indexed: bool) -> str:
    """The page of a case whose last run gave no results, with the reason."""
    return render("unjudged.md.j2", _filters(), case=case)


def index(index: Index) -> str:
    """The index, in the folder of the manual."""
    return render("index.md.j2", _filters(), index=index, wording=wording)


def _filters() -> dict[str, Callable[..., str]]:
    return {
        "significant": number.significant,
        "short": number.short,
        "decimals": number.decimals,
        "positional": number.positional,
        "fraction": number.fraction,
        "code": escape.code,
        "link": escape.link,
    }


def _relative(path: Path, folder: Path) -> str:
    """The address of a file, relative to `folder`."""
    try:
        return escape.link(Path(os.path.relpath(path, folder)).as_posix())
    except ValueError:  # another drive
        return path.resolve().as_uri()
