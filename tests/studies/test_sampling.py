import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.studies.sweep.sampling import grid, latin_hypercube, sampled

RANGES = {"m": (0.1, 10.0), "nu": (0.0, 0.4)}


def generator():
    return np.random.Generator(np.random.PCG64(3))


@given(st.integers(1, 60))
def test_each_part_of_each_range_has_one_point(count):
    points = latin_hypercube(RANGES, count, generator())
    parts = {
        "m": [np.log10(point["m"] / 0.1) / 2.0 for point in points],
        "nu": [point["nu"] / 0.4 for point in points],
    }
    for places in parts.values():
        cells = np.array(sorted(places)) * count
        assert np.all(np.abs(cells - np.arange(count) - 0.5) <= 0.5 + 1e-2 * count)  # data have four digits


def test_the_same_seed_gives_the_same_points_and_another_others():
    def every(point):
        return True

    assert sampled(RANGES, 8, 0, every) == sampled(RANGES, 8, 0, every)
    assert sampled(RANGES, 8, 0, every) != sampled(RANGES, 8, 1, every)


def test_points_that_are_not_accepted_are_replaced():
    points = sampled(RANGES, 50, 0, lambda point: point["m"] > 1.0)
    assert len(points) == 50
    assert min(point["m"] for point in points) > 1.0
    assert sampled(RANGES, 50, 0, lambda point: False) == []


def test_a_grid_has_the_corners_of_the_region():
    points = grid(RANGES, 3)
    assert len(points) == 9
    assert {point["m"] for point in points} == {0.1, 1.0, 10.0}
    assert {point["nu"] for point in points} == {0.0, 0.2, 0.4}


def test_data_are_short_enough_to_type():
    points = latin_hypercube(RANGES, 20, generator())
    assert all(
        len(f"{value:g}") <= 9 and float(f"{value:.3e}") == value for p in points for value in p.values()
    )


@pytest.mark.parametrize("count", [1, 7])
def test_points_lie_within_their_ranges(count):
    narrow = {"x": (1.00001, 1.00002)}
    assert all(1.00001 <= point["x"] <= 1.00002 for point in latin_hypercube(narrow, count, generator()))
