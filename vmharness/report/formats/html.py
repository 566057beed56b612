"""The manual as HTML: each page is one file that works offline, without scripts, and can be printed."""

import datetime
import re
from collections.abc import Callable
from pathlib import Path

from vmharness import __version__
from vmharness.events import Event
from vmharness.formula import Unit
from vmharness.report import equations, escape, machine, number, prose, wording
from vmharness.report.figures.curves import time_factor, time_unit
from vmharness.report.index import Index
from vmharness.report.page import Page
from vmharness.report.templates import render
from vmharness.result import CaseRun, Unrun

FILE = "index.html"


def case(page: Page, folder: Path) -> str:
    """The page of a case; it is complete in itself and does not use `folder`."""
    case = page.run.case
    pictures = prose.pictures(case)
    return render(
        "case.html.j2",
        _filters(),
        page=page,
        run=page.run,
        file=case.file,
        inputs=[
            (name, prose.data_link(content, "text/plain")) for name, content in _inputs(page.run).items()
        ],
        prose={title: prose.html(text, pictures) for title, text in page.prose.items()},
        theory=lambda line: equations.theory_pieces(line, page),
        datum=lambda datum: equations.datum(datum, "mathml").replace(' display="block"', ""),
        wording=wording,
        provenance=provenance(page.run) if page.volatile else {},
    )


def _inputs(run: CaseRun) -> dict[str, bytes]:
    """The input files of the run by name; the deck is the one that ran."""
    case = run.case
    files = {name: (case.folder / name).read_bytes() for name in case.input_files}
    deck = run.solution.resolved_deck.encode() or case.deck_path.read_bytes()
    return {case.deck_name: deck, **files}


def unjudged(case: Unrun, indexed: bool) -> str:
    """The page of a case whose last run gave no results, with the reason; `indexed`: there is an index."""
    return render("unjudged.html.j2", _filters(), case=case, indexed=indexed)


def index(index: Index) -> str:
    """The index, with links to the pages of the cases."""
    return render("index.html.j2", _filters(), index=index, wording=wording)


def provenance(run: CaseRun) -> dict[str, str]:
    """Solver, versions, machine and times of this run, which differ from run to run."""
    solution = run.solution
    return {
        "Solver": solution.solver,
        **solution.facts,
        "Cycles": str(solution.cycles),
        **_events(run),
        "Time in the solver": f"{solution.seconds:.2f} s, of which {solution.seconds_loop:.2f} s in the time loop",
        "vmharness": __version__,
        "Python": machine.python(),
        **machine.versions(),
        "System": machine.system(),
        "Processor": machine.processor(),
        "Machine": machine.host(),
        "Date": datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d %H:%M UTC"),
    }


def _events(run: CaseRun) -> dict[str, str]:
    """The time of each event and its uncertainty by sampling, in the unit of the results that are times."""
    unit, factor = time_unit(run.case), time_factor(run.case)
    return {
        run.case.file.events[name].title: f"{event.time / factor:.9g} {unit} "
        f"± {event.uncertainty / factor:.1g} {unit} by sampling"
        for name, event in run.events.items()
        if isinstance(event, Event)
    }


def _filters() -> dict[str, Callable[..., str]]:
    return {
        "significant": lambda value: _minus(number.significant(value)),
        "short": lambda value: _minus(number.short(value)),
        "decimals": lambda value, places=4: _minus(number.decimals(value, places)),
        "minus": _minus,
        "signs": _signs,
        "positional": lambda value, digits=3: _minus(number.positional(value, digits)),
        "fraction": number.fraction,
        "link": escape.link,
        "unit": lambda text: Unit(text).html() or "–",
    }


def _signs(text: str) -> str:
    """Text with minus signs in place of hyphens before numbers.

    >>> _signs("VM-061: -2.5e-3, by-product")
    'VM-061: −2.5e−3, by-product'
    """
    return re.sub(r"(?<!\w)-(?=\d)|(?<=\de)-(?=\d)", "−", text)


def _minus(text: str) -> str:
    """A number with a minus sign in place of a hyphen."""
    return text.replace("-", "−")
