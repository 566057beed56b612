"""The manual as Markdown that a code host renders: the same bytes wherever the same results are written."""

import os
from collections.abc import Callable
from pathlib import Path

from vmharness.report import equations, number, wording
from vmharness.report.index import Index
from vmharness.report.page import Page
from vmharness.report.templates import render
from vmharness.result import CaseRun

FILE = "README.md"


def case(page: Page, folder: Path) -> str:
    """The page of a case, to lie in `folder` beside its figures."""
    return render(
        "case.md.j2",
        _filters(),
        page=page,
        run=page.run,
        file=page.run.case.file,
        inputs=_inputs(page.run, folder),
        theory=lambda line: equations.theory(line, page, "latex"),
        datum=lambda datum: equations.datum(datum, "latex"),
        wording=wording,
    )


def _inputs(run: CaseRun, folder: Path) -> list[tuple[str, str]]:
    """Links to what was put into the run; a deck that is not the case's own lies beside the page."""
    case = run.case
    deck = folder / case.deck_name if run.solution.resolved_deck else case.deck_path
    paths = {name: case.folder / name for name in case.input_files}
    return [(name, _relative(path, folder)) for name, path in {case.deck_name: deck, **paths}.items()]


def index(index: Index) -> str:
    """The index, to lie in the folder of the manual."""
    return render("index.md.j2", _filters(), index=index, wording=wording)


def _filters() -> dict[str, Callable[..., str]]:
    return {
        "significant": number.significant,
        "short": number.short,
        "decimals": number.decimals,
        "positional": number.positional,
        "fraction": number.fraction,
        "cell": _cell,
        "plain": _plain,
    }


def _plain(text: str) -> str:
    """Text in which no tag is hidden."""
    return text.replace("<", "&lt;")


def _cell(text: str) -> str:
    """Text that stays in its cell of a table."""
    return " ".join(_plain(text).replace("|", "\\|").split())


def _relative(path: Path, folder: Path) -> str:
    """A link from `folder`, with the slashes of links."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:  # another drive
        return path.resolve().as_uri()
