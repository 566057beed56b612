"""The cases of impact on rigid walls and of the pendulum pass, and fail with the faults that they declare."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.run import run

NAMES = ("D-40", "D-70", "VM-083", "VM-085", "VM-091", "VM-265")
CASES = {name: read(Path(__file__).parents[1] / "cases" / name) for name in NAMES}
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


def test_momentum_of_the_bouncing_bar_is_what_the_walls_gave():
    h = builtin.solve(CASES["D-70"]).history
    np.testing.assert_allclose(h["p"], h["p"][0] + h["J_1"] + h["J_2"], atol=1e-12 * h["p"][0])
    assert np.ptp(h["J_1"]) > 9.0 * h["p"][0]
