"""Decks follow the data of their cases: with another radius, length or curve, solver and theory agree as before."""

from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.run import run

CASES = Path(__file__).parents[1] / "cases"


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("D-44", {"V": 9.0}),
        ("D-45", {"L": 60.0, "n": 800.0}),
        ("D-49", {"R": 0.2, "b": 0.004}),
        ("D-51-beam", {"L": 0.7}),
        ("D-51-shell", {"L": 0.7}),
        ("D-59", {"a": 0.8}),
        ("VM-156", {"beta": 0.5, "D": 1.5}),
    ],
)
def test_other_data_pass_too(name, changes):
    result = run(read(CASES / name).with_given(changes), builtin)
    assert result.verdict is Verdict.PASS, [(row.key, row.comparison) for row in result.rows]
