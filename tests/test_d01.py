"""D-01, D-49 and D-59: within their tolerances as they lie in their folders, and out of them with any declared fault."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.run import run

CASES = {name: read(Path(__file__).parents[1] / "cases" / name) for name in ("D-01", "D-49", "D-59")}
FAULTS = [
    pytest.param(CASES[name], fault, id=f"{name}: {fault.text}")
    for name in CASES
    for fault in CASES[name].file.faults
]


@pytest.mark.parametrize("name", CASES)
def test_every_result_is_within_its_tolerance(name):
    result = run(CASES[name], builtin)
    assert result.verdict is Verdict.PASS, [(row.key, row.comparison) for row in result.rows]


@pytest.mark.parametrize(("case", "fault"), FAULTS)
def test_declared_faults_fail_what_they_must(case, fault):
    wrong = run(planted(case, fault), builtin)
    failed = {row.key for row in wrong.rows if row.verdict is Verdict.FAIL}
    assert set(fault.must_fail) <= failed


def test_free_fall_is_exact_to_rounding():
    errors = [row.comparison.error_percent for row in run(CASES["D-01"], builtin).rows]
    assert max(map(abs, errors)) < 1e-11
