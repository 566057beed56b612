from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.case import CaseError, read
from vmharness.case.deck import read_deck
from vmharness.case.format import Fault
from vmharness.case.template import render
from vmharness.solve import solve
from vmharness.studies.faults.declared import faulty_data

BAR = Path(__file__).parents[2] / "cases" / "D-37"


def made(tmp_path, text, **values):
    path = tmp_path / "deck.k.j2"
    path.write_text(text)
    return render(path, values)


def test_whole_numbers_are_integers(tmp_path):
    text = made(
        tmp_path, "{% for i in range(n) %}\n{{ '%8d%16.6f'|format(i, L / n) }}\n{% endfor %}\n", n=2.0, L=1.0
    )
    assert text == "       0        0.500000\n       1        0.500000\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("*KEYWORD\n{{ m }}", r"deck.k.j2: 'm' is undefined"),
        ("*KEYWORD\n{% for %}", r"deck.k.j2:2: "),
        ("{{ n.__class__.__mro__ }}", r"unsafe"),
        ("{{ 1 / 0 }}", r"division by zero"),
        ("{{ range(100000000) }}", r"Range too big"),
        ("{% include '/etc/passwd' %}", r"no loader|loader"),
    ],
)
def test_what_is_wrong_is_said_and_nothing_unsafe_is_done(tmp_path, text, message):
    with pytest.raises(CaseError, match=message):
        made(tmp_path, text, n=2.0)


@pytest.mark.parametrize("n", [50, 200])
def test_a_mesh_follows_from_the_data(n):
    case = read(BAR).with_given({"n": float(n)})
    deck = read_deck(case)
    (table,) = deck.all("ELEMENT_BEAM")
    assert len(table.eid) == n
    (nodes,) = deck.all("NODE")
    place = dict(zip(nodes.nid.tolist(), nodes.x.tolist(), strict=True))
    assert (place[1], place[401], place[801]) == (0.0, 0.5, 1.0)


def test_a_fault_in_what_only_the_template_uses_is_in_the_deck():
    sound = read(BAR)
    assert not any("n" in sound.origins(f"parameter {name}") for name in sound.file.deck.parameters)
    coarser = Fault(text="A coarser bar", change={"n": "=50"}, must_fail=["t_arrival"])
    wrong = sound.with_deck_of(faulty_data(sound, coarser))
    assert len(read_deck(wrong).one("ELEMENT_BEAM").eid) == 50
    assert wrong.values == sound.values
    assert wrong.changed == frozenset()
    assert sound.with_deck_of({"n": 200.0}).deck_source() == sound.with_given({"n": 200.0}).deck_source()


def test_the_deck_that_ran_is_kept():
    case = read(BAR).with_given({"n": 50.0})
    solution = solve(case, builtin)
    assert not solution.failure
    again = case.with_deck(solution.resolved_deck)
    assert len(read_deck(again).one("ELEMENT_BEAM").eid) == 50
    assert case.deck_name == "deck.k"
    assert solve(read(BAR), builtin).resolved_deck.splitlines()[2].startswith("D-37: bar fixed at one end")


def test_a_mesh_that_lacks_the_measured_node_cannot_run():
    assert "no *NODE 401" in solve(read(BAR).with_given({"n": 25.0}), builtin).failure
