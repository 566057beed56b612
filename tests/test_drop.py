"""Loose blocks dropped into a box, as in benchmarks/drop.py, of which this is the smaller version."""

import importlib
from pathlib import Path


def test_loose_blocks_come_to_rest_in_a_box(monkeypatch):
    monkeypatch.syspath_prepend(str(Path(__file__).parents[1] / "benchmarks"))
    found = importlib.import_module("drop").figures(3)
    assert found.kinetic < 1e-4
    assert 0.0 < found.deepest < 0.02
    assert found.out == 0
    assert abs(found.ratio - 1.0) < 0.02
    assert found.ended < 100.0
