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
        ("*KEYWORD\n{{ m }}", r"deck.k.j2:2: 'm' is undefined"),
        ("*KEYWORD\n{% for %}", r"deck.k.j2:2: "),
        ("{{ n.__class__.__mro__ }}", r"deck.k.j2:1: .*unsafe"),
        ("\n\n{{ 1 / 0 }}", r"deck.k.j2:3: division by zero"),
        ("{{ range(100000000) }}", r"deck.k.j2:1: Range too big"),
        ("{% include '/etc/passwd' %}", r"no loader|loader"),
        ("\n{% macro f() %}{{ f() }}{% endmacro %}\n{{ f() }}", r"deck.k.j2:2: calls itself without end"),
        ("\n{{ " + 3000 * "(" + "n" + 3000 * ")" + " }}", r"deck.k.j2:2: nested too deeply"),
        ("\n{{ " + 100 * "-" + "n }}", r"deck.k.j2:2: nested deeper than 80"),
        (
            30 * "{% for i in [1] %}\n" + 30 * "{% endfor %}",
            r"deck.k.j2:2\d: too many statically nested blocks",
        ),
        ("\n{% macro f(n, n) %}{% endmacro %}", r"deck.k.j2:2: duplicate argument"),
        ("\n{{ 'a' * 10**11 }}", r"deck.k.j2:2: a text or list repeated 100000000000 times is longer"),
        ("\n{{ 10**(10**10) }}", r"deck.k.j2:2: a power with the exponent 10000000000 is too large"),
        ("\n{{ 'a'|center(10**11) }}", r"deck.k.j2:2: takes more memory than 2 GB"),
        ("\n{{ 'a'|center(99999999999) }}", r"deck.k.j2:2: takes more memory than 2 GB"),
        ("\n{{ '%099999999999d' % n }}", r"deck.k.j2:2: "),
        ("a\nb\n{{ '\\ud800' }}", r"deck.k.j2:3: makes '\\ud800', which no file can hold"),
        ("a\nb\n{{ '%c' % 55296 }}", r"deck.k.j2:3: makes '\\ud800', which no file can hold"),
        ("\n{{ [1].nothing.at.all }}", r"deck.k.j2:2: .*no attribute 'nothing'"),
        ("\n{{ {}|first + 1 }}", r"deck.k.j2:2: "),
        ("\n{{ n|nofilter }}", r"deck.k.j2:2: No filter named 'nofilter'"),
        ("\n{{ n(1) }}", r"deck.k.j2:2: 'int' object is not callable"),
    ],
)
def test_what_is_wrong_is_said_with_its_line_and_nothing_unsafe_is_done(tmp_path, text, message):
    with pytest.raises(CaseError, match=message):
        made(tmp_path, text, n=2.0)


def test_a_deck_without_end_ends(tmp_path):
    endless = "\n{% for i in range(99999) %}\n{% for j in range(99999) %}\n{{ 200 * 'x' }}\n{% endfor %}\n{% endfor %}"
    with pytest.raises(CaseError, match=r"deck.k.j2:4: (the deck has more than 2e\+08|takes more memory)"):
        made(tmp_path, endless)


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
