"""Planted faults: in the unit of the datum, and how far theory says that they move what must fail."""

from pathlib import Path

import msgspec
import numpy as np
import pytest

from vmharness.case import read
from vmharness.studies.faults.declared import faulty_data, moves, review

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


@pytest.fixture
def in_feet(tmp_path):
    """The case with its height of 1 in given in feet."""
    text = (BALL / "case.toml").read_text()
    given = 'h  = { value = 1.0, unit = "in"'
    assert given in text
    (tmp_path / "case.toml").write_text(text.replace(given, f'h  = {{ value = {1 / 12!r}, unit = "ft"'))
    for name in ("deck.k", "post.cfile"):
        (tmp_path / name).write_bytes((BALL / name).read_bytes())
    return read(tmp_path)


def fault(case, number, **changes):
    return msgspec.structs.replace(case.file.faults[number], **changes)


def test_a_value_is_in_the_unit_of_its_datum(in_feet):
    half_a_foot = fault(in_feet, 3, change={"h": "=0.5"}, must_fail=["z_impact"])
    assert in_feet.with_deck_of(faulty_data(in_feet, half_a_foot)).deck_parameters()["H"] == pytest.approx(
        6.0, rel=1e-14
    )
    assert moves(in_feet, half_a_foot)["z_impact"].percent == pytest.approx(500.0)


def test_every_fault_of_the_manual_moves_what_must_fail_beyond_its_tolerance():
    case = read(BALL)
    assert review(case) == []
    moved = moves(case, case.file.faults[1])  # gravity 0.1 % too strong: t = sqrt(2 h/g)
    assert moved["t_impact"].percent == pytest.approx(100.0 * (1.001**-0.5 - 1.0), rel=1e-9)
    assert moved["t_impact"].tolerances == pytest.approx((1.0 - 1.001**-0.5) / 5e-7, rel=1e-9)


def test_a_target_of_zero_moves_by_no_percentage(tmp_path):
    text = (BALL / "case.toml").read_text()
    key = 'target    = "z_impact"\nunit      = "in"\ntolerance = { relative = 1e-6'
    assert key in text
    other = 'target    = "h - 1.0*h"\nunit      = "in"\ntolerance = { absolute = 1e-6'
    (tmp_path / "case.toml").write_text(text.replace(key, other))
    for name in ("deck.k", "post.cfile"):
        (tmp_path / name).write_bytes((BALL / name).read_bytes())
    case = read(tmp_path)
    move = moves(case, fault(case, 3, must_fail=["z_impact"]))["z_impact"]
    assert (move.percent, move.tolerances) == (None, 0.0)


def test_a_reading_at_a_given_time_moves_with_the_theory_of_its_channel():
    case = read(BALL.parent / "D-51-beam")
    denser = next(fault for fault in case.file.faults if "rho" in fault.change)
    moved = moves(case, denser)["w_1"]
    case_denser = case.with_given({"rho": 1.02 * case.given["rho"]})
    time = np.array([case.theory["t_1"]])
    expected = case_denser.curve("w", time)[0] / case.theory["w_1"] - 1.0
    assert moved.percent == pytest.approx(100.0 * expected, rel=1e-6)
    assert moved.percent < -1.0  # a slower beam, at the same time


def test_a_fault_that_moves_only_the_level_is_none(fall):
    # another node falls in the same way: where it is at the level, so is the first
    other = 'other = { node = 2, component = "z-displacement", text = "Displacement" }\n'
    curve = 'other = { formula = "-g*t^2/2", text = "Displacement" }\n'
    level = 'crossing_of = "other", level = "z_T", direction = "down"'
    two = (("[channels]\n", f"[channels]\n{other}"), ("[curves]\n", f"[curves]\n{curve}"))
    (displacement, *_) = review(read(fall(*two, ('at = "T"', level))))
    assert displacement == (
        "[faults] 1 (Gravity 0.1 % too strong): z_T must fail, but "
        "where the curves of the faulty theory have its event, it has the sound value"
    )


def test_a_fault_that_is_seen_at_a_moving_level_is_one(fall):
    # a quarter of the way: the faulty fall is there earlier
    level = ('at = "T"', 'crossing_of = "z", level = "-1.0*g*T^2/8", direction = "down"')
    time = (
        'channel   = "z"\ntarget    = "z_T"\nunit      = "m"',
        'channel   = "time"\ntarget    = "T/2"\nunit      = "s"',
    )
    energy = ('must_fail = ["z_T", "ke_T"]', 'must_fail = ["z_T"]')
    kinetic = ('target    = "ke_T"', 'target    = "ke_T/4"')
    case = read(fall(level, time, energy, kinetic))
    assert review(case) == []
    assert moves(case, case.file.faults[0])["z_T"] is None  # by the targets alone it cannot be told


SPEED = ("[channels]\n", '[channels]\nv = { node = 1, component = "z-velocity", text = "Velocity" }\n')
CURVES = (
    "[curves]\n",
    '[curves]\nv = { formula = "-g*t", text = "v" }\nkinetic = { formula = "m*(g*t)^2/2", text = "T" }\n',
)
ENERGY = ('must_fail = ["z_T", "ke_T"]', 'must_fail = ["ke_T"]')


@pytest.mark.parametrize("level", ["-g*T", "v_T"])
def test_the_kinetic_energy_at_a_velocity_tells_nothing_of_gravity(fall, level):
    # m v^2/2 at the level of v: whatever gravity is, and also where the level is a datum of its own
    given = (
        "[given]\n",
        '[given]\nv_T = { value = -4.905, unit = "m/s", group = "Loading", text = "Velocity" }\n',
    )
    event = ('at = "T"', f'crossing_of = "v", level = "{level}", direction = "down"')
    unseen = (
        "ke_T must fail, but where the curves of the faulty theory have its event, it has the sound value"
    )
    assert unseen in review(read(fall(given, SPEED, CURVES, event, ENERGY)))[0]


def test_without_curves_it_cannot_be_told(fall):
    event = ('at = "T"', 'crossing_of = "v", level = "-g*T", direction = "down"')
    (sentence, *_) = review(read(fall(SPEED, event, ENERGY)))
    assert "add [curves] of kinetic and v to tell what is read there" in sentence
