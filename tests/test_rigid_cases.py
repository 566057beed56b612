"""Cases of rigid bodies: energy balances, and targets are those derived independently."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.run import run

CASES = Path(__file__).parents[1] / "cases"


def test_the_energy_of_the_pendulum_balances():
    history = run(read(CASES / "D-31"), builtin).solution.history
    assert np.abs(history["ratio"][len(history) // 20 :] - 1.0).max() < 1e-4


@pytest.mark.parametrize(
    ("id", "exact"),
    [
        ("D-31", {"T": 1.93333485, "omega": 5.424942, "pin": 2.5 * 0.785 * 9.81}),
        ("D-32", {"t_back": 2 * np.pi / 2.00997512, "kinetic": 1.02}),
        ("D-34", {"v_turn": -0.0654}),
        ("D-26", {"v_roll": 3.571429, "t_99": 0.99 * 0.4854133 + 1e-3 / 9.81}),
    ],
)
def test_targets_are_those_derived_independently(id, exact):
    case = read(CASES / id)
    for key, value in exact.items():
        assert case.target(key) == pytest.approx(value, rel=2e-6)
