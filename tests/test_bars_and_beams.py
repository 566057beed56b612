"""The cases of bars and beams pass, and fail with the faults that they declare."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.run import run

NAMES = ("VM-084", "D-37", "D-51-beam", "D-51-shell", "D-51-solid")
CASES = {name: read(Path(__file__).parents[1] / "cases" / name) for name in NAMES}
FAULTS = [(name, fault) for name, case in CASES.items() for fault in case.file.faults]


@pytest.mark.parametrize("name", CASES)
def test_passes(name):
    assert run(CASES[name], builtin).verdict is Verdict.PASS


@pytest.mark.parametrize(("name", "fault"), FAULTS, ids=lambda item: getattr(item, "text", item))
def test_declared_faults_fail_what_they_must(name, fault):
    wrong = run(planted(CASES[name], fault), builtin)
    failed = {row.key for row in wrong.rows if row.verdict is Verdict.FAIL}
    assert set(fault.must_fail) <= failed
