from hypothesis import given
from hypothesis import strategies as st

from vmharness.studies.sweep.shrink import shrink

OWN = {"m": 1.0, "k": 100.0, "h": 2.0}


def shrunk(point, fails):
    return shrink(point, OWN, lambda attempts: [fails({**OWN, **attempt}) for attempt in attempts])


def test_only_the_datum_that_matters_is_left():
    point = {"m": 3.217, "k": 812.6, "h": 1.113}
    found = shrunk(point, lambda at: at["k"] > 300.0)
    assert list(found) == ["k"]
    assert 300.0 < found["k"] <= 450.0
    assert float(f"{found['k']:.1e}") == found["k"]


def test_two_data_that_matter_together_are_both_left():
    found = shrunk({"m": 3.217, "k": 812.6, "h": 1.113}, lambda at: at["m"] > 2.0 and at["h"] < 1.5)
    assert list(found) == ["m", "h"]


@given(st.floats(1.5, 9.0), st.floats(150.0, 900.0))
def test_what_is_found_fails_still_and_is_never_further_away(m, k):
    def fails(at):
        return at["m"] * at["k"] > 210.0

    found = shrunk({"m": m, "k": k}, fails)
    assert fails({**OWN, **found})
    assert abs(found.get("m", 1.0) - 1.0) <= abs(m - 1.0) + 0.6
    assert shrunk(found, fails) == found


def test_a_point_that_cannot_be_made_simpler_stays():
    point = {"m": 3.217}
    assert shrunk(point, lambda at: at["m"] == 3.217) == point
