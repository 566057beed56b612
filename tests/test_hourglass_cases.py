"""D-64: hourglass modes as theory has them, and no pass for a solver whose elements do not resist them."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.run import run

CASES = {name: read(Path(__file__).parents[1] / "cases" / name) for name in ("D-64-shell", "D-64-solid")}
FAULTS = [
    pytest.param(CASES[name], fault, id=f"{name}: {fault.text}")
    for name in CASES
    for fault in CASES[name].file.faults
]


@pytest.mark.parametrize("name", CASES)
def test_no_error_exceeds_its_budget(name):
    clean = run(CASES[name], builtin)
    assert clean.verdict is Verdict.PASS
    for row in clean.rows:
        assert abs(row.comparison.error_percent) <= 100 * row.budget, row.key


@pytest.mark.parametrize(("case", "fault"), FAULTS)
def test_declared_faults_fail_what_they_must(case, fault):
    wrong = run(planted(case, fault), builtin)
    failed = {row.key for row in wrong.rows if row.verdict is Verdict.FAIL}
    assert set(fault.must_fail) <= failed
