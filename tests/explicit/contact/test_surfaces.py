"""Surfaces of a deck: what belongs to them, how stiff and thick it is."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError

ONE_WAY = "*CONTACT_NODES_TO_SURFACE\n{a},{b},{akind},{bkind}\n{two}\n{three}\n"
AUTOMATIC = ONE_WAY.replace("CONTACT_", "CONTACT_AUTOMATIC_")


def contact(b=1, bkind=3, a=8, akind=4, two="", three="", cards="", of=ONE_WAY):
    return of.format(a=a, b=b, akind=akind, bkind=bkind, two=two, three=three) + cards


@pytest.mark.parametrize(
    ("number", "kind", "count"),
    [(1, 3, 2), (2, 3, 6), (5, 2, 10), (5, 6, 2), (6, 1, 1), (7, 0, 1), (0, 5, 12)],
)
def test_a_surface_has_the_outer_faces_of_what_it_names(sides, number, kind, count):
    # A face that two parts share is outside of each, and inside of both together.
    assert sides(contact(number, kind)).faces("b").pid.size == count


def test_tracked_nodes_are_those_of_the_set_or_of_the_outer_faces(sides):
    numbers = sides(contact()).model.ids
    assert numbers[sides(contact()).nodes("a")].tolist() == [5, 11, 31]
    assert numbers[sides(contact(a=6, akind=1)).nodes("a")].tolist() == [2, 3, 5]
    assert numbers[sides(contact(a=3, akind=3)).nodes("a")].tolist() == [21, 22, 23, 24, 31, 32, 33, 34]


def test_stiffness_is_k_a_over_d_of_shells_and_k_a_squared_over_v_of_solids(sides):
    shells = sides(contact()).faces("b")
    np.testing.assert_allclose(shells.penalty, [4.0 / math.sqrt(8.0), 2.0 / math.sqrt(8.0)])
    brick = sides(contact(2)).faces("b")
    np.testing.assert_allclose(np.sort(brick.penalty), 2.0 * np.array([1, 1, 4, 4, 4, 4]) / 2.0)
    np.testing.assert_allclose(np.sort(brick.depth), [1.0] * 4 + [2.0] * 2)


def test_scale_factors_go_with_their_sides(sides):
    found = sides(contact(three="3.0,5.0") + "*CONTROL_CONTACT\n0.5\n\n")
    faces, nodes = found.faces("b"), found.nodes("a")
    np.testing.assert_allclose(found.segments("b", faces, nodes).penalty, 0.5 * 5.0 * faces.penalty)
    tracked = found.tracked("a", nodes)
    # Node 5 has a triangle, 11 the lower brick, 31 the upper: the stiffest face of each.
    np.testing.assert_allclose(tracked.penalty, 0.5 * 3.0 * np.array([2.0 / math.sqrt(8.0), 4.0, 2.0]))
    np.testing.assert_allclose(tracked.area, [2.0 / 3.0, (1 + 2 + 2) / 4.0, 3.0 / 4.0])
    assert np.isinf(sides(contact() + "*CONTROL_CONTACT\n0.5,,,,2\n\n").tracked("a", nodes).penalty).all()


def test_thickness_counts_in_automatic_contacts_and_where_shlthk_asks(sides):
    def thickness(text):
        found = sides(text)
        nodes = found.nodes("a")
        tracked, segments = found.tracked("a", nodes), found.segments("b", found.faces("b"), nodes)
        return pytest.approx([*tracked.thickness, *segments.thickness])

    assert thickness(contact()) == [0.0] * 5
    assert thickness(contact(of=AUTOMATIC)) == [0.1, 0.0, 0.0, 0.1, 0.1]
    assert thickness(contact(cards="\n,,1\n")) == [0.1, 0.0, 0.0, 0.1, 0.1]
    assert thickness(contact() + "*CONTROL_CONTACT\n,,,2\n\n") == [0.1, 0.0, 0.0, 0.1, 0.1]
    assert thickness(contact(of=AUTOMATIC, three=",,0.3,0.2,9,9")) == [0.3, 0.0, 0.0, 0.2, 0.2]
    assert thickness(contact(of=AUTOMATIC, three=",,,,2,3")) == [0.2, 0.0, 0.0, 0.3, 0.3]
    assert thickness(contact(2, of=AUTOMATIC)) == [0.1] + [0.0] * 8


def test_a_single_surface_caps_thickness_at_two_fifths_of_the_shortest_side(sides):
    text = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,3\n\n,,5.0\n"
    for control, expected in (("", 0.8), ("*CONTROL_CONTACT\n\n,,,,,1\n", 5.0)):
        found = sides(text + control, single=True)
        faces = found.faces("a")
        np.testing.assert_allclose(found.segments("a", faces, found.nodes("a")).thickness, expected)
        np.testing.assert_allclose(found.tracked("a", found.nodes("a")).thickness, expected)
    assert sides(text.replace("1,0,3", "0,0,0"), single=True).faces("a").pid.size == 12


@pytest.mark.parametrize(
    ("text", "shell", "solid"),
    [
        (contact(0, 5), np.inf, np.inf),
        (contact(0, 5, cards="\n0.7\n"), 0.7, 0.7),
        (contact(0, 5, two=",,,,,1"), 0.4, 4.0),
        (contact(0, 5, two=",,,,,1") + "*CONTROL_CONTACT\n\n,,,,3.0\n", 0.3, 3.0),
        (contact(0, 5, two=",,,,,2"), 0.05 * math.sqrt(8.0), 0.05 * math.sqrt(2.0)),
        (contact(0, 5, of=AUTOMATIC), 0.04, 0.5),
        (contact(0, 5, of=AUTOMATIC, cards="\n2.0\n"), 0.2, 2.0),
    ],
)
def test_depth_of_release(sides, text, shell, solid):
    found = sides(text)
    faces, nodes = found.faces("b"), found.nodes("a")
    depth = found.segments("b", faces, nodes).release
    np.testing.assert_allclose(depth[0], shell)
    (top,) = np.flatnonzero((found.model.x0[faces.nodes][:, :, 2] == 4.0).all(axis=1))  # V/A = 1
    np.testing.assert_allclose(depth[top], solid)


def test_only_automatic_shells_have_two_sides(sides):
    for of, expected in ((ONE_WAY, 0), (AUTOMATIC, 2)):
        found = sides(contact(0, 5, of=of))
        segments = found.segments("b", found.faces("b"), found.nodes("a"))
        assert segments.two_sided.sum() == expected


@pytest.mark.parametrize(("orien", "turned"), [(1, True), (2, True), (4, False)])
def test_shells_face_the_tracked_nodes_as_orien_says_and_solids_stay(sides, orien, turned):
    found = sides(contact(0, 5, a=9) + "*SET_NODE_LIST\n9\n1\n" + f"*CONTROL_CONTACT\n,,,,,,{orien}\n\n")
    found.model.x0[found.nodes("a")] = [0.5, 0.5, -9.0]
    faces = found.faces("b")
    changed = (found.segments("b", faces, found.nodes("a")).nodes != faces.nodes).any(axis=1)
    assert changed.tolist() == (faces.shell & turned).tolist()


def test_a_segment_takes_its_element_by_its_corners_and_keeps_its_own_order(sides):
    found = sides(contact(7, 0)).faces("b")
    assert found.eid.tolist() == [11]
    assert found.penalty.tolist() == [1.0]
    assert sides(contact()).model.ids[found.nodes[0]].tolist() == [14, 13, 12, 11]


BEAM = """*PART
beam
4,4,1
*SECTION_BEAM
4,3
1.0
*ELEMENT_BEAM
41,4,4,14
"""


def test_beams_of_exempt_parts_are_no_part_of_the_surface(sides):
    exempt = BEAM + "*SET_PART_LIST\n19\n2,3,4\n"
    assert sides(exempt + contact(19, 6)).faces("b").pid.tolist() == [1, 1]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "*SET_SEGMENT\n17\n1,2,3,5\n" + contact(17, 0),
            r"N1 = 1: no shell and no face of a solid has the nodes",
        ),
        (
            "*SET_SHELL_LIST\n16\n1,9\n" + contact(16, 1),
            r"\*SET_SHELL_LIST: SHELLS = 9: no \*ELEMENT_SHELL 9",
        ),
        (contact(44, 3), r"SURFB = 44: no \*PART with PID = 44"),
        ("*PART\nempty\n9,1,1\n" + contact(9, 3), r"SURFB = 9: the surface has neither shells nor solids"),
        (
            "*PART\nempty\n9,1,1\n*SET_PART_LIST\n19\n2,9\n" + contact(19, 2),
            r"SURFB = 19: part 9 of the set has neither shells nor solids",
        ),
        *(
            (
                "*SET_PART_LIST\n19\n2,9\n" + contact(19, kind),
                r"deck.k:\d+: \*SET_PART_LIST: PARTS = 9: no \*PART",
            )
            for kind in (2, 6)
        ),
        *(
            (
                BEAM + contact(number, kind),
                rf"_SURFACE: SURFB = {number}: part 4 is beams, whose contact is not",
            )
            for number, kind in ((0, 5), (5, 6))
        ),
    ],
)
def test_what_is_no_surface_is_refused(sides, text, message):
    with pytest.raises(DeckError, match=message):
        sides(text).faces("b")
