from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.deck import DeckError, Entry, vocabulary
from vmharness.deck import read as read_keywords
from vmharness.solve import solve
from vmharness.studies.changed_deck import with_entries, with_step

CASES = Path(__file__).parents[2] / "cases"


@pytest.mark.parametrize("id", ["VM-061", "D-51-beam"])  # without and with *CONTROL_TIMESTEP
def test_the_time_step_is_scaled_through_the_deck(id):
    case = read(CASES / id)
    deck = read_deck(case)
    tssfac = read_deck(with_step(case, 0.5)).one("CONTROL_TIMESTEP").tssfac
    assert tssfac == pytest.approx(0.45)
    assert len(read_deck(with_step(case, 0.5)).all("NODE")) == len(deck.all("NODE"))


def test_an_entry_of_defaults_is_what_a_blank_card_gives(tmp_path):
    (tmp_path / "deck.k").write_text("*KEYWORD\n*CONTROL_TIMESTEP\n\n*END\n")
    blank = read_keywords(tmp_path / "deck.k", vocabulary()).one("CONTROL_TIMESTEP")
    assert Entry.of_defaults(blank.keyword).values == blank.values


def test_half_the_step_takes_twice_the_cycles(ball):
    whole, half = solve(ball, builtin), solve(with_step(ball, 0.5), builtin)
    assert half.cycles == pytest.approx(2 * whole.cycles, abs=1)
    assert half.resolved_deck.startswith("*KEYWORD LONG=Y")


def test_a_step_that_follows_a_curve_is_refused(ball):
    curved = ball.with_deck(ball.deck_text.replace("*END", "*CONTROL_TIMESTEP\n0,0.9,0,0,0,1\n*END"))
    with pytest.raises(DeckError, match="LCTM = 1: a step that follows a curve is not scaled"):
        with_step(curved, 0.5)


def test_entries_can_be_taken_away(ball):
    free = with_entries(
        ball, lambda deck: [entry for entry in deck.entries if "BOUNDARY" not in entry.spelled]
    )
    assert not read_deck(free).all("BOUNDARY_SPC_SET")
    assert len(read_deck(free).entries) == len(read_deck(ball).entries) - 1
