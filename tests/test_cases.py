"""Every case of the manual: it passes within its error budget, and fails with each fault that it declares."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.case.tolerance import review
from vmharness.compare import Verdict
from vmharness.run import run
from vmharness.studies.faults.declared import faulty_data

FOLDERS = sorted(path.parent for path in (Path(__file__).parents[1] / "cases").glob("*/case.toml"))
CASES = [read(folder) for folder in FOLDERS]
FAULTS = [
    pytest.param(case, fault, id=f"{case.id}: {fault.text}") for case in CASES for fault in case.file.faults
]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_no_error_exceeds_its_budget(case):
    clean = run(case, builtin)
    assert clean.verdict is Verdict.PASS, clean.reason
    for row in clean.rows:
        if case.target(row.key):
            assert abs(row.comparison.error_percent) <= 100 * row.budget, row.key


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_budgets_justify_tolerances(case):
    assert review(case) == ([], [])


@pytest.mark.parametrize(("case", "fault"), FAULTS)
def test_declared_faults_fail_what_they_must(case, fault):
    wrong = run(case.with_deck_of(faulty_data(case, fault)), builtin)
    assert wrong.verdict is Verdict.FAIL
    failed = {row.key for row in wrong.rows if row.verdict is Verdict.FAIL}
    assert set(fault.must_fail) <= failed
