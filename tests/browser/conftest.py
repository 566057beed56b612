"""A manual and a browser: pages of a few cases made without a solver, or those of the folder VMHARNESS_PAGES."""

import os
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.compare import Tolerance, compare
from vmharness.formula import Unit
from vmharness.history import History
from vmharness.mesh.view import view_of
from vmharness.report import write_case, write_index, write_unjudged
from vmharness.result import CaseRun, Published, Row, Solution, Unrun

ROOT = Path(__file__).parents[2]
# The widest formulas and tables of the manual, and cases of other solvers' columns.
CASES = ["VM-061", "VM-182", "D-20", "D-26", "D-51-shell"]
NAMES = ["chromium", "chromium-browser", "google-chrome"]
MISSING = "no Chromium on this machine, so no page is looked at: install it (apt-get install chromium)"


PATIENCE = 600_000.0  # ms until a browser counts as hanging; no measure of speed


@pytest.fixture(scope="session")
def manual(tmp_path_factory):
    """The folder of a manual with its pages (HTML)."""
    if "VMHARNESS_PAGES" in os.environ:
        return Path(os.environ["VMHARNESS_PAGES"]).resolve()
    root = tmp_path_factory.mktemp("manual")
    runs = [run_without_solver(read(ROOT / "cases" / name)) for name in CASES]
    runs[0] = failed(runs[0])
    unrun = Unrun(
        "D-0", "D-0/case.toml: [results] 3: a reason that is longer than a line of the page of the case"
    )
    for run in runs:
        records = ROOT / "reports" / run.case.id / "studies"
        if records.is_dir():
            shutil.copytree(records, root / run.case.id / "studies")
        write_case(run, root, indexed=True)
    write_unjudged(unrun, root, indexed=True)
    write_index(runs, root, [unrun])
    return root


@pytest.fixture(scope="session")
def pages(manual):
    """Addresses of all pages by name."""
    found = {path.parent.name: path.as_uri() for path in sorted(manual.glob("*/index.html"))}
    assert found, f"no pages in {manual}"
    return {"index": (manual / "index.html").as_uri(), **found}


@pytest.fixture(scope="session")
def browser():
    """Chromium, driven by Playwright; where it is missing the tests are skipped, but not for a manual that is named."""
    path = next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.fail(MISSING) if "VMHARNESS_PAGES" in os.environ else pytest.skip(MISSING)
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        yield playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])


@pytest.fixture
def tab(browser):
    """An empty tab, in which the scripts of a test may run."""
    context = browser.new_context(bypass_csp=True)
    context.set_default_timeout(PATIENCE)
    yield context.new_page()
    context.close()


def run_without_solver(case):
    """A run in which every result lies a third of its tolerance from its target, with theory for its history."""
    time = Unit(case.file.units.time).dimension
    end = max(value for name, value in case.theory.items() if case.dimensions[name] == time)
    t = np.linspace(0.0, end, 400)
    channels = {name: np.zeros_like(t) for name in case.file.channels}
    channels |= {name: case.curve(name, t) for name in case.file.curves}
    solution = Solution("vmharness 9.9.9", History(t, channels), view=view_of(read_deck(case)))
    rows = tuple(row(case, result) for result in case.file.results)
    return CaseRun(case, solution, rows, {}, {}, "d" * 64, "c" * 64, 1.0)


def row(case, result):
    target = case.target(result.key) / case.units.factor(Unit(result.unit))
    tolerance = Tolerance(result.tolerance.relative, result.tolerance.absolute)
    return Row(
        key=result.key,
        label=result.label,
        event=case.file.events[result.event].title,
        unit=result.unit,
        comparison=compare(target, target + tolerance.allowed(target) / 3.0, tolerance),
        uncertainty=None,
        because=result.tolerance.because,
        budget=None,
        published={
            column.name: Published(column.values[result.key], column.errors_percent.get(result.key))
            for column in case.file.published
            if result.key in column.values
        },
    )


def failed(run):
    """The run with its first result three tolerances from its target."""
    first, *rest = run.rows
    c = first.comparison
    far = compare(c.target, c.target + 3.0 * c.tolerance.allowed(c.target), c.tolerance)
    return replace(run, rows=(replace(first, comparison=far), *rest))
