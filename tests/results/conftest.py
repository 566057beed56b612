import importlib
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def _module(name):
    """A module beside the tests."""
    sys.path.insert(0, str(Path(__file__).parent))
    try:
        return importlib.import_module(name)
    finally:
        sys.path.pop(0)


@pytest.fixture(scope="session")
def lsdyna():
    """The writers of LS-DYNA's text files."""
    return _module("lsdyna")


@pytest.fixture(scope="session")
def binary():
    """The writers of binary files."""
    return _module("binary")


@pytest.fixture(scope="session")
def solved():
    """Runs a case with the built-in solver, once in a session: `solved("VM-061", name=Channel(...))` is its history."""
    from vmharness.backends import backend
    from vmharness.backends.protocol import Job
    from vmharness.case import read
    from vmharness.case.deck import read_deck

    kept = {}

    def solve(id, **more):
        if (id, *more) not in kept:
            case = read(ROOT / "cases" / id)
            output = backend("builtin").solve(Job(read_deck(case), {**case.file.channels, **more}, Path()))
            assert not output.failure
            kept[id, *more] = case, output.history
        return kept[id, *more]

    return solve


@pytest.fixture
def written(lsdyna, solved, tmp_path):
    """Writes what a solver here makes of a case as LS-DYNA's text files: `written("VM-084")` is case, history, folder."""

    def write(id, **options):
        case, history = solved(id)
        folder = tmp_path / "results of a run" / id
        folder.mkdir(parents=True)
        _module("written").write(lsdyna, folder, case, history, **options)
        return case, history, folder

    return write
