"""Cases of contact: they pass, each planted fault fails them, and budgets justify tolerances."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.backends import builtin
from vmharness.case import Case, read
from vmharness.compare import Verdict
from vmharness.evidence.faults import planted
from vmharness.evidence.tolerance import review
from vmharness.run import run

CASES = Path(__file__).parents[1] / "cases"
IDS = ["D-18", "D-20", "D-22", "D-23", "D-28-shell", "D-28-solid", "D-29"]


@pytest.fixture(params=IDS)
def case(request) -> Case:
    return read(CASES / request.param)


def test_passes_with_errors_that_the_budget_covers(case):
    judged = run(case, builtin)
    assert judged.verdict is Verdict.PASS, judged.reason
    for row in judged.rows:
        if case.target(row.key):
            assert abs(row.comparison.error_percent) / 100.0 <= 1.01 * row.budget, row.key
    assert review(case) == ([], [])


def test_every_planted_fault_fails(case):
    for fault in case.file.faults:
        wrong = {row.key for row in run(planted(case, fault), builtin).rows if row.verdict is Verdict.FAIL}
        assert wrong >= set(fault.must_fail), fault.text


@pytest.mark.parametrize("id", ["D-18", "D-20", "D-22", "D-23"])
def test_energy_balances(id):
    """Kinetic energy, that of the contacts and what friction took, against the start and the work of gravity."""
    ratio = run(read(CASES / id), builtin).solution.history["ratio"]
    assert np.abs(ratio[len(ratio) // 20 :] - 1.0).max() < 1e-3


@pytest.mark.parametrize(
    ("id", "exact"),
    [
        ("D-18", {"t_begin": 0.0719815751 + 9 * 0.20088972, "t_finish": 0.1289081 + 9 * 0.20088972, "F_max": 1086.970}),
        ("D-20", {"v1_1": 1 / 3, "v2_1": 13 / 3, "v1_2": 1.0, "v2_2": 3.0, "F_max": -326.5986}),
        ("D-22", {"t_A": 0.99 * 1.698947, "x_A_end": 4.247366}),
        ("D-23", {"v_A": (0.5 + 2.356287) * 3**0.5 / 2}),
    ],
)  # fmt: skip
def test_targets_are_those_derived_independently(id, exact):
    case = read(CASES / id)
    for key, value in exact.items():
        assert case.target(key) == pytest.approx(value, rel=5e-7)
