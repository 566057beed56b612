"""Sensitivities of the ball on the surface, against derivatives taken by hand."""

from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from vmharness.case import read
from vmharness.studies.faults.declared import in_deck
from vmharness.studies.sensitivity import POINTS, derivative, sensitivities, smallest_seen

CASES = Path(__file__).parents[2] / "cases"


@pytest.fixture(scope="module")
def ball():
    return read(CASES / "VM-061")


@pytest.fixture(scope="module")
def of_ball(ball):
    return sensitivities(ball)


def test_powers_have_their_exponents(of_ball):
    # t = sqrt(2 h/g), v = -sqrt(2 g h), E = m g h
    expected = {
        "t_impact": {"h": 0.5, "g": -0.5, "m": 0.0, "k": 0.0},
        "v_impact": {"h": 0.5, "g": 0.5, "m": 0.0, "k": 0.0},
        "ke_impact": {"h": 1.0, "g": 1.0, "m": 1.0, "k": 0.0},
    }
    for key, powers in expected.items():
        for name, power in powers.items():
            assert of_ball[name][key].percent == pytest.approx(power, abs=1e-10)


def test_the_peak_moves_as_its_derivative_says(ball, of_ball):
    # z = -(h + y0 + a), a^2 = 2 h y0 + y0^2, y0 = m g/k:  dz/d ln k = y0 + (h y0 + y0^2)/a
    h, y0, a = ball.given["h"], ball.theory["y_static"], ball.theory["amplitude"]
    slope = (y0 + (h * y0 + y0**2) / a) / ball.target("z_peak")
    assert of_ball["k"]["z_peak"].percent == pytest.approx(slope, rel=1e-9)
    assert of_ball["m"]["z_peak"].percent == pytest.approx(-slope, rel=1e-9)


def test_a_fault_of_the_size_that_is_seen_is_one_tolerance(ball, of_ball):
    seen = of_ball["k"]["z_peak"].seen
    wrong = ball.with_given({"k": (1.0 + seen / 100.0) * ball.given["k"]})
    share = abs(wrong.target("z_peak") / ball.target("z_peak") - 1.0) / 1e-5
    assert share == pytest.approx(1.0, rel=1e-4)
    assert smallest_seen(of_ball["g"]) == ("t_impact", pytest.approx(100 * 5e-7 / 0.5))


def test_what_no_target_depends_on_is_never_seen(of_ball):
    assert smallest_seen(of_ball["dt"]) is None
    assert all(one.percent == 0.0 for one in of_ball["E"].values())


def test_only_the_length_of_the_run_is_no_part_of_the_problem(ball):
    deck = msgspec.structs.replace(ball.file.deck, parameters={"M": "m", "TEND": "t_end"})
    case = replace(ball, file=msgspec.structs.replace(ball.file, deck=deck))
    assert in_deck(case, "m")
    assert not in_deck(case, "h")  # it sets the end of the run alone
    found = sensitivities(case)["h"]
    assert found["t_impact"].percent == pytest.approx(0.5)
    assert smallest_seen(found) is None


def test_the_mesh_of_a_template_is_part_of_the_problem():
    bar = read(CASES / "D-37")
    assert in_deck(bar, "L")
    assert in_deck(bar, "n")


def test_a_jump_has_no_derivative():
    assert derivative([float(x > 1.0) for x in POINTS]) is None
    assert derivative([x**-2.0 for x in POINTS]) == pytest.approx(-2.0, rel=1e-12)
    assert derivative([float("nan")] * 4) is None
