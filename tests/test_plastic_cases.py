"""The cases of plasticity through the built-in solver: within their budgets, and unable to pass when something is wrong."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.run import run

CASES = {name: read(Path(__file__).parents[1] / "cases" / name) for name in ("D-44", "D-65")}
FAULTS = [(name, fault) for name, case in CASES.items() for fault in case.file.faults]


@pytest.mark.parametrize("name", CASES)
def test_no_error_exceeds_its_budget(name):
    clean = run(CASES[name], builtin)
    assert clean.verdict is Verdict.PASS
    for row in clean.rows:
        assert abs(row.comparison.error_percent) <= 100 * row.budget, row.key


@pytest.mark.parametrize(("name", "fault"), FAULTS, ids=[f"{name} {fault.text}" for name, fault in FAULTS])
def test_declared_faults_fail_what_they_must(name, fault):
    wrong = run(planted(CASES[name], fault), builtin)
    failed = {row.key for row in wrong.rows if row.verdict is Verdict.FAIL}
    assert set(fault.must_fail) <= failed
