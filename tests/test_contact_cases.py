"""Cases of contact: energy balances, and targets are those derived independently."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.run import run

CASES = Path(__file__).parents[1] / "cases"


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
