"""Degrees of freedom whose motion the deck gives."""

import pytest

from vmharness.deck import read, vocabulary
from vmharness.mesh.driven import driven, driven_bodies
from vmharness.mesh.nodes import nodes_of

DECK = """*KEYWORD
*CONTROL_TERMINATION
1.0
*NODE
1,0.0,0.0,0.0,1,0
2,1.0,0.0,0.0
3,2.0,0.0,0.0
*SET_NODE_LIST
1
2,3
*DEFINE_CURVE
1
0.0,1.0
9.0,1.0
{}
*END
"""
MOTION = "*BOUNDARY_PRESCRIBED_MOTION_{}"
ROTATIONS = (3, 4, 5)


@pytest.fixture
def given(tmp_path):
    """By node, the degrees of freedom that the deck with these cards gives: 0 to 2 translations, 3 to 5 rotations."""

    def of(*cards):
        deck = read(tmp_path / "deck.k", vocabulary(), text=DECK.format("\n".join(cards)))
        nodes = nodes_of(deck)
        return {
            int(id): set(flags.nonzero()[0]) for id, flags in zip(nodes.ids, driven(deck, nodes), strict=True)
        }

    return of


def test_supports_hold(given):
    assert given() == {1: {0}, 2: set(), 3: set()}
    assert given("*BOUNDARY_SPC_NODE", "2,0,0,1,0,0,0,1") == {1: {0}, 2: {1, 5}, 3: set()}


@pytest.mark.parametrize("vad", [0, 1, 2])
def test_motions_prescribe_whatever_their_kind(given, vad):
    assert given(MOTION.format("NODE"), f"3,2,{vad},1") == {1: {0}, 2: set(), 3: {1}}
    assert given(MOTION.format("SET"), f"1,5,{vad},1") == {1: {0}, 2: {3}, 3: {3}}


@pytest.mark.parametrize("times", ["0.5,0.0", "0.0,0.5"])
def test_a_motion_for_a_part_of_the_run_leaves_the_rest_to_the_solver(given, times):
    death, birth = times.split(",")
    assert given(MOTION.format("NODE"), f"3,2,0,1,1.0,0,{death},{birth}")[3] == set()


def body(con1=0, con2=0, *cards):
    return (
        "*MAT_RIGID", "1,7800.0,2e11,0.3", f"1.0,{con1},{con2}", "",
        "*SECTION_BEAM", "1,3", "1e-4",
        "*PART", "body", "1,1,1",
        "*ELEMENT_BEAM", "1,1,2,3",
        *cards,
    )  # fmt: skip


def test_a_body_is_held_by_its_material_and_driven_by_its_motion(given, tmp_path):
    motion = (MOTION.format("RIGID"), "1,1,0,1")
    deck = read(tmp_path / "deck.k", vocabulary(), text=DECK.format("\n".join(body(3, 6, *motion))))
    assert set(driven_bodies(deck)[1].nonzero()[0]) == {
        0,
        2,
        3,
        5,
    }  # x by the curve, z by CON1; about z, x by CON2
    assert given(*body(3, 6, *motion))[2] == set()  # a rotation about y moves its nodes
    assert given(*body(3, 7, *motion))[2] == {0, 2, *ROTATIONS}
    assert given(*body(3, 7, *motion))[1] == {0}  # of no element
