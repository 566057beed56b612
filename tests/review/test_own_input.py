"""Results that read only what the deck prescribes."""

from pathlib import Path

import pytest

from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.case.format import Channel
from vmharness.deck import read as deck_of
from vmharness.deck import vocabulary
from vmharness.review.own_input import by_one_name, is_given, own_input

CASES = Path(__file__).parents[2] / "cases"
NODE = "       1             0.0             0.0             0.0       0       0"
HELD = NODE[: -len("0       0")] + "3       0"  # in z
PRESCRIBED = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,3,2,1\n*LOAD_BODY_Z"
CROSSING = 'crossing_of = "z", level = "z_T", direction = "down"'
TIME = 'channel   = "time"\ntarget    = "T"\nunit      = "s"'
DISPLACEMENT = 'channel   = "z"\ntarget    = "z_T"\nunit      = "m"'
WALLS = """*KEYWORD
*RIGIDWALL_PLANAR

0.0,0.0,0.0,0.0,0.0,1.0
*RIGIDWALL_PLANAR_MOVING_ID
7

0.0,0.0,0.0,0.0,0.0,1.0
2.0,1.0
*END
"""


def found(folder):
    case = read(folder)
    return own_input(case, read_deck(case))


def test_what_the_solver_computes_is_a_result(fall):
    assert found(fall()) == []


@pytest.mark.parametrize("change", [(NODE, HELD), ("*LOAD_BODY_Z", PRESCRIBED)])
def test_a_motion_that_the_deck_gives_is_none(fall, change):
    (sentence,) = found(fall(change))
    assert sentence.startswith("[results] 1: z_T: z is held or prescribed by the deck: ")
    assert "cannot disagree" in sentence


def test_the_time_at_which_a_prescribed_motion_reaches_a_level_is_none(fall):
    level = ('at = "T"', CROSSING)
    (sentence,) = found(fall(("*LOAD_BODY_Z", PRESCRIBED), level, (DISPLACEMENT, TIME)))
    assert sentence.startswith("[results] 1: z_T: z is held or prescribed")
    assert found(fall(level, (DISPLACEMENT, TIME))) == []


@pytest.mark.parametrize(
    ("component", "given"),
    [("z-displacement", True), ("z-velocity", True), ("z-coordinate", True), ("x-displacement", False)],
)
def test_only_the_direction_that_is_held_is_given(fall, component, given):
    case = read(fall((NODE, HELD)))
    assert is_given(read_deck(case), Channel(text="", node=1, component=component)) == given


@pytest.mark.parametrize(
    ("wall", "component", "given"),
    [
        (1, "z-velocity", True),
        (1, "normal-displacement", True),
        (1, "z-force", False),
        (7, "z-velocity", False),
    ],
)
def test_a_fixed_wall_has_a_force_but_no_motion(tmp_path, wall, component, given):
    deck = deck_of(tmp_path / "deck.k", vocabulary(), text=WALLS)
    assert is_given(deck, Channel(text="", wall=wall, component=component)) == given


@pytest.mark.parametrize("held", [True, False])
def test_the_centre_of_mass_of_a_single_node_is_that_node(fall, held):
    centre = 'c = { centre = "all", component = "z-velocity", text = "Velocity" }\nv = { node = 1, '
    speed = 'component = "z-velocity", text = "Velocity" }\n'
    level = ('at = "T"', 'crossing_of = "c", level = "-g*T", direction = "down"')
    velocity = (
        'channel   = "z"\ntarget    = "z_T"\nunit      = "m"',
        'channel = "v"\ntarget = "-g*T"\nunit = "m/s"',
    )
    other = f"{NODE}\n{NODE.replace('1', '2', 1)}"
    nodes = (NODE, other[: -len("0       0")] + "7       0" if held else other)
    sentences = found(fall(("[channels]\n", f"[channels]\n{centre}{speed}"), level, velocity, nodes))
    assert len(sentences) == held
    assert all("v and c are the same quantity: there it is the level itself" in each for each in sentences)


def test_all_supports_are_the_only_one_and_the_only_part_is_the_model(fall):
    deck = read_deck(read(fall((NODE, f"{NODE}\n{NODE[:-9].replace('1', '2', 1)}7       0"))))
    force = Channel(text="", support="all", component="z-force")
    assert by_one_name(deck, force) == Channel(text="", support=2, component="z-force")
    part = Channel(text="", energy="internal", part=1)
    assert by_one_name(deck, part) == part  # the deck has none
    bar = read_deck(read(CASES / "VM-085"))
    assert by_one_name(bar, part) == Channel(text="", energy="internal")
