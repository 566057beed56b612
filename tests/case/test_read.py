"""case.toml: what is wrong is said with table, entry and what would be right."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from vmharness.case import Case, CaseError, read
from vmharness.events import Event
from vmharness.history import History
from vmharness.measure import find_event

CASES = Path(__file__).parents[2] / "cases"


@pytest.fixture
def edited(tmp_path):
    """Read VM-061 after replacing text of its case.toml."""
    folder = tmp_path / "VM-061"
    shutil.copytree(CASES / "VM-061", folder)

    def read_edited(*replacements: tuple[str, str]) -> Case:
        text = (CASES / "VM-061" / "case.toml").read_text()
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new, 1)
        (folder / "case.toml").write_text(text)
        return read(folder)

    return read_edited


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('key       = "z_impact"', 'key       = "z_impact"\nfoo = 1', r"\[results\] 2: unknown key foo"),
        ("tolerance = { relative", "tolerence = { relative", r"\[results\] 1: unknown key tolerence; did you mean tolerance"),
        ('because = "about ten', 'becuase = "about ten', r"\[results\] 1\.?tolerance: .*becuase.*because|because is missing"),
        ("{ relative = 5e-7, ", "{ ", r"\[results\] 1: the tolerance is zero"),
        ("relative = 5e-7", "relative = -5e-7", r"\[results\].*>= 0"),
        ('target    = "z_peak"', 'target    = "z_peak - z_peak"', r"\[results\] 6: the target is 0: only an absolute tolerance can judge it"),
        ('target    = "z_peak"', 'target    = "z_peek"', r"\[results\] 6: target: z_peek is not defined here; did you mean z_peak"),
        ('unit      = "in/s"', 'unit      = "in"', r"\[results\] 3: unit in does not fit: the formula is in in/s"),
        ('event     = "peak"', 'event     = "paek"', r"\[results\] 5: there is no event paek; did you mean peak"),
        ('channel   = "kinetic"', 'channel   = "kin"', r"\[results\] 4: there is no channel kin; did you mean kinetic"),
        ('key       = "z_impact"', 'key       = "t_impact"', r"\[results\] 2: key t_impact is used twice"),
        ('omega     = { formula = "sqrt(k/m)"', 'omega     = { formula = "sqrt(k/n)"', r"\[theory\] omega: n is not defined here"),
        ('formula = "sqrt(2*h/g)"', 'formula = "sqrt(2*h/g"', r"\[theory\] t_impact: "),
        ('formula = "-(h + y_max)"', 'formula = "-(h + omega)"', r"\[theory\] z_peak: .*same unit"),
        ('formula = "m*v_impact^2/2"', 'formula = "__import__(\'os\')"', r"\[theory\] ke_impact: "),
        ('unit = "rad/s"', 'unit = "in"', r"\[theory\] omega: unit in does not fit"),
        ('unit = "lbf/in"', 'unit = "lbx/in"', r"\[given\] k: .*lbx"),
        ('length = "in"', 'length = "lbf"', r"\[units\]: "),
        ('onset_of = "contact_force"', 'onset_of = "force"', r"\[events\] impact: there is no channel force"),
        ('minimum_of = "z"', 'minimum_of = "z", level = "h"', r"\[events\] peak: level and direction belong to crossing_of"),
        ("node = 5, component", "node = 5, shell = 1, component", r"\[channels\] z: needs just one of node, shell"),
        ('minimum_of = "z"', 'at = "h"', r"\[events\] peak: at = h: a time is expected, but the unit is in"),
        ('minimum_of = "z"', 'at = "t_peak", maximum_of = "z"', r"\[events\] peak: needs just one of at, onset_of"),
        ('minimum_of = "z"', 'at = "t_peek"', r"\[events\] peak: t_peek is not defined here; did you mean t_peak"),
        ('minimum_of = "z"', 'at = "t_peak"', r"\[results\] 5: the time of peak is given, so it cannot be a result"),
        ('change    = { k = "+1 %" }', 'change    = { k = "1" }', r'\[faults\] 1: k = "1": write "\+1 %"'),
        ('change    = { k = "+1 %" }', 'change    = { kk = "+1 %" }', r"\[faults\] 1: there is no given datum kk"),
        ('must_fail = ["t_peak", "z_peak"]', "must_fail = []", r"\[faults\] 1.*length >= 1"),
        ('z = { formula = "where(t < t_impact, -g*t^2/2', 'z = { formula = "where(t < t_impact, -g*t/2', r"\[curves\] z: .*unit"),
        ('SLSFAC = "slsfac"', 'SLSFAC = "slsfak"', r"\[deck.parameters\] SLSFAC: slsfak is not defined here; did you mean slsfac"),
        ('file = "deck.k"', 'file = "../deck.k"', r"\.\./deck\.k: lies outside the case's folder"),
        ('file = "deck.k"', 'file = "dack.k"', r"dack\.k: there is no such file"),
        ('t_impact = "0.071998"', 't_impact = "0.07l998"', r"\[published\] 1: t_impact = '0.07l998' is not a number"),
        ("[units]", "[units", r"not TOML"),
        ('title     = "Transient', 'titel     = "Transient', r"unknown key titel; did you mean title"),
    ],
)  # fmt: skip
def test_a_wrong_file_is_told_where_and_what(edited, old, new, message):
    with pytest.raises(CaseError, match=r"^VM-061/(case.toml: )?.*" + message):
        edited((old, new))


def test_a_value_at_a_given_time_is_read_there(edited):
    case = edited(
        ('impact = { onset_of = "contact_force"', 'impact = { at = "t_impact/2"'),
        ('channel   = "time"', 'channel   = "z"'),
        ('target    = "t_impact"\nunit      = "s"', 'target    = "-h"\nunit      = "in"'),
    )
    half = 0.5 * case.theory["t_impact"]
    event = find_event(case, "impact", History(np.linspace(0.0, 1.0, 11), {}))
    assert event == Event(half, 0.0)
    late = find_event(case, "impact", History(np.linspace(0.0, 0.9 * half, 11), {}))
    assert "lies outside the run, 0 to 0.03239" in late


def test_a_folder_without_a_case_is_told(tmp_path):
    with pytest.raises(CaseError, match=r"no case.toml can be read"):
        read(tmp_path)


def test_targets_are_those_of_the_closed_form():
    # cases of the manual: exact values derived independently, see also test_vm061_twice.py
    case = read(CASES / "VM-061")
    exact = dict(
        t_impact=0.0719815751, v_impact=-27.7848880, ke_impact=193.0, z_peak=-1.5506656, t_peak=0.1004448599
    )
    for key, value in exact.items():
        assert case.target(key) == pytest.approx(value, rel=1e-8)


def test_curves_are_continuous_and_energies_add_up():
    case = read(CASES / "VM-061")
    t = np.linspace(0.0, 0.11, 1001)
    curve = {name: case.curve(name, t) for name in case.file.curves}
    np.testing.assert_allclose(curve["kinetic"] + curve["contact"], curve["external"], rtol=1e-12, atol=1e-9)
    np.testing.assert_allclose(np.gradient(curve["z"], t)[1:-1], curve["v"][1:-1], atol=2e-3 * 27.8)
    edge = np.array([np.nextafter(case.theory["t_impact"], 0.0), case.theory["t_impact"]])
    for name in curve:
        assert np.ptp(case.curve(name, edge)) < 1e-9 * np.abs(curve[name]).max()


def test_other_data_move_theory_and_deck_together():
    case = read(CASES / "VM-061")
    assert case.deck_parameters() == {}
    other = case.with_given({"k": 4000.0})
    assert other.theory["omega"] == pytest.approx(np.sqrt(8000.0))
    parameters = other.deck_parameters()
    assert parameters["SLSFAC"] == pytest.approx(2.7915e-4 * 4000.0 / 1973.92, rel=2e-5)
    assert parameters["TEND"] == pytest.approx(1.1 * other.theory["t_peak"])
    assert set(parameters) == set(case.file.deck.parameters)  # all: nothing of the file's rounding is left
    exact = case.with_given({"m": 0.6}).deck_parameters()
    assert exact["SLSFAC"] == case.theory["slsfac"] != 2.7915e-4


def test_a_datum_comes_back_in_its_own_unit(edited):
    case = edited(('h  = { value = 1.0, unit = "in"', 'h  = { value = 25.4, unit = "mm"'))
    assert case.datum("h") == 25.4
    assert case.with_given({"h": 30.3 / 25.4}).datum("h") == 30.3


def test_other_data_than_those_they_were_printed_for_have_no_published_values():
    case = read(CASES / "VM-061")
    assert [column.name for column in case.published] == ["LS-DYNA", "VM65"]
    assert case.with_given({"k": 4000.0}).published == []


def test_a_planted_fault_moves_the_deck_alone():
    case = read(CASES / "VM-061")
    wrong = case.with_deck_of({"g": 1.001 * 386.0})
    assert wrong.theory == case.theory
    assert wrong.deck_parameters()["G"] == pytest.approx(386.386)


def test_data_that_no_parameter_follows_cannot_be_set():
    case = read(CASES / "VM-061")
    with pytest.raises(CaseError, match="dt cannot be set: nothing in the deck depends on it"):
        case.with_given({"dt": 1e-5})
    with pytest.raises(CaseError, match="no given datum q; there are: m, k"):
        case.with_given({"q": 1.0})
    with pytest.raises(CaseError, match="t_impact"):
        case.with_given({"g": 0.0})
