import math
from pathlib import Path

import pytest

from vmharness.case import CaseError, read
from vmharness.case.settings import SettingError, label, parse, with_settings

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


@pytest.mark.parametrize("setting", ["m", "=1", "m=", "m=heavy", "m=nan", "m=inf", "m=1 kg", "m==1"])
def test_only_names_and_finite_numbers(setting):
    with pytest.raises(SettingError, match="NAME=NUMBER"):
        parse([setting])


def test_a_name_is_set_once():
    with pytest.raises(SettingError, match="m is set twice"):
        parse(["m=1", "m=2"])


def test_theory_and_deck_both_move():
    case = with_settings(read(BALL), parse(["h=4", "g=100"]))
    assert case.theory["t_impact"] == pytest.approx(math.sqrt(2 * 4 / 100), rel=1e-14)
    assert case.deck_parameters()["H"] == 4.0
    assert case.deck_parameters()["G"] == 100.0


def test_the_number_is_in_the_unit_in_which_the_case_gives_it(tmp_path):
    text = (BALL / "case.toml").read_text()
    given = 'h  = { value = 1.0, unit = "in"'
    assert given in text
    (tmp_path / "case.toml").write_text(text.replace(given, 'h  = { value = 0.5, unit = "ft"'))
    for name in ("deck.k", "schematic.svg", "post.cfile"):
        (tmp_path / name).write_bytes((BALL / name).read_bytes())
    assert with_settings(read(tmp_path), {"h": 0.25}).given["h"] == pytest.approx(3.0, rel=1e-14)


def test_an_unknown_datum_and_near_names():
    with pytest.raises(CaseError, match="VM-061: no given datum gg; did you mean g"):
        with_settings(read(BALL), {"gg": 0.3})


def test_data_for_which_theory_has_no_value():
    with pytest.raises(CaseError, match="t_impact"):
        with_settings(read(BALL), {"g": -386.0})


def test_labels_keep_every_digit():
    assert label("VM-061", {"k": 1973.9200000001}) == "VM-061@k=1973.9200000001"
