"""D-01: what its tolerances need not ask for."""

from pathlib import Path

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.run import run

CASE = read(Path(__file__).parents[1] / "cases" / "D-01")


def test_free_fall_is_exact_to_rounding():
    errors = [row.comparison.error_percent for row in run(CASE, builtin).rows]
    assert max(map(abs, errors)) < 1e-11
