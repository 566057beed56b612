import importlib
from pathlib import Path

import pytest


@pytest.fixture
def work(monkeypatch):
    """A module that worker processes can import, too."""
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    return importlib.import_module("pool_work")
