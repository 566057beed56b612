import importlib
from pathlib import Path

import pytest

from vmharness.case import read

CASES = Path(__file__).parents[2] / "cases"


@pytest.fixture
def store(tmp_path, monkeypatch):
    """A store of outcomes that is empty, beside the compiled kernels that there are."""
    monkeypatch.setattr("vmharness.studies.gather.root", lambda: tmp_path)
    return tmp_path


@pytest.fixture
def ball():
    """VM-061 in steps of 0.1 ms."""
    case = read(CASES / "VM-061")
    return case.with_deck(case.deck_path.read_text().replace("RRHO         7.3E-4", "RRHO         2.5437"))


@pytest.fixture
def work(monkeypatch):
    """A module that worker processes can import, too."""
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    return importlib.import_module("study_work")
