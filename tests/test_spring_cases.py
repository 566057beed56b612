"""Cases of springs, dampers and masses: energy balances, and targets are those derived independently."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.backends import builtin
from vmharness.case import Case, read
from vmharness.run import run

CASES = Path(__file__).parents[1] / "cases"
IDS = ["D-15", "VM-071", "VM-072", "VM-075", "VM-080", "VM-156", "VM-182"]


@pytest.fixture(params=IDS)
def case(request) -> Case:
    return read(CASES / request.param)


def test_energy_balances(case):
    """Kinetic, stored and dissipated energy together, against the work put in, once there is enough of it."""
    history = run(case, builtin).solution.history
    assert np.abs(history["ratio"][len(history) // 20 :] - 1.0).max() < 2e-3


@pytest.mark.parametrize(
    ("id", "exact"),
    [
        ("VM-071", {"x_over": 0.47419782, "x_critical": 0.18998475, "x_under": -0.52108497, "x_free": -0.99688532}),
        ("VM-072", {"t_1": 0.185069, "x_1": 1.0 / 1.535137}),
        ("VM-075", {"x_free": 2.0, "x_free_read": 1.653644, "x_damped_read": 1.153123, "x_damped": 1.163034, "t_damped": 0.181380}),
        ("VM-080", {"t_max": 0.0668622, "x_max": 0.804337, "t_min": 0.122225, "x_min": 0.437766}),
        ("VM-156", {"t_period": 0.14404387}),
        ("VM-182", {"x1_a": 14.477151, "x2_a": 3.987149, "x1_b": 18.321644, "x2_b": 6.136599}),
    ],
)  # fmt: skip
def test_targets_are_those_derived_independently(id, exact):
    case = read(CASES / id)
    for key, value in exact.items():
        assert case.target(key) == pytest.approx(value, rel=2e-6, abs=1e-8)
