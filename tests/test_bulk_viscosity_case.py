"""D-45-viscosity: the viscous pressure and its heat as formulas have them, and nothing passes that is not."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.run import run

CASE = read(Path(__file__).parents[1] / "cases" / "D-45-viscosity")


def test_no_error_exceeds_its_budget():
    clean = run(CASE, builtin)
    assert clean.verdict is Verdict.PASS
    for row in clean.rows:
        assert abs(row.comparison.error_percent) <= 100 * row.budget, row.key


@pytest.mark.parametrize("fault", CASE.file.faults, ids=lambda fault: fault.text)
def test_declared_faults_fail_what_they_must(fault):
    wrong = run(planted(CASE, fault), builtin)
    failed = {row.key for row in wrong.rows if row.verdict is Verdict.FAIL}
    assert set(fault.must_fail) <= failed
