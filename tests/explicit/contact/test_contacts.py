"""The contact keywords at work: which nodes are held against which segments, where, and what can be read off."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.limits import limits_reached
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe
from vmharness.mesh.view import view_of

# The wall of the fixture is 0.1 thick, and K A/d = sqrt(2); node 5 is a ball of mass 0.5.
BALL = "*ELEMENT_MASS\n105,5,0.5\n*SET_NODE_LIST\n2\n5\n*CONTROL_CONTACT\n1.0\n\n"
BRICKS = """*KEYWORD
*CONTROL_TERMINATION
3.0
*PART
lower
1,1,1
*PART
upper
2,1,1
*SECTION_SOLID
1,1
*MAT_ELASTIC
1,1.0,100.0,0.0
*ELEMENT_SOLID
1,1,1,2,3,4,5,6,7,8
2,2,11,12,13,14,15,16,17,18
"""


def ball(z, vz, x=0.0):
    return f"*NODE\n5,{x},0.0,{z}\n*INITIAL_VELOCITY_NODE\n5,,,{vz}\n" + BALL


def cube(first, low, size, shift=0.0):
    """Nodes of a cube that stands on z = low, in the order of a solid's."""
    corners = [(0, 0), (size, 0), (size, size), (0, size)]
    places = [(x + shift, y + shift, low + h) for h in (0.0, size) for x, y in corners]
    return "*NODE\n" + "".join(f"{first + i},{x},{y},{z}\n" for i, (x, y, z) in enumerate(places))


def contact_of(model):
    return next(force for force in model.forces if isinstance(force, Contact))


def bricks(deck, keyword, cards, gap=0.01):
    """Two cubes of side 1, the upper one smaller and coming down."""
    moving = "".join(f"*INITIAL_VELOCITY_NODE\n{nid},,,-0.1\n" for nid in range(11, 19))
    text = BRICKS + cube(1, 0.0, 1.0) + cube(11, 1.0 + gap, 0.5, 0.25) + moving
    return deck(text + f"*CONTACT_{keyword}\n{cards}\n\n\n")


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_an_automatic_contact_begins_at_half_the_thickness_on_either_side(wall_and, side):
    model = wall_and(
        ball(0.06 * side, -side) + "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,1,4,3\n\n\n", end=10.0
    )
    contact = contact_of(model)
    for s in steps(model):
        height = s.x[4, 2] * side
        if contact.force.any():
            break
    assert 0.05 - s.dt <= height <= 0.05
    assert contact.force[2] * side == pytest.approx(math.sqrt(2.0) * (0.05 - height), rel=1e-9)


def test_a_two_way_contact_has_two_passes_and_the_others_one(deck):
    passes = {
        name: [
            (one.nodes.size, one.segments.size) for one in contact_of(build(bricks(deck, name, cards))).passes
        ]
        for name, cards in (
            ("ONE_WAY_SURFACE_TO_SURFACE", "2,1,3,3"),
            ("SURFACE_TO_SURFACE", "2,1,3,3"),
            ("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3"),
            ("AUTOMATIC_SINGLE_SURFACE", "0"),
        )
    }
    assert passes["ONE_WAY_SURFACE_TO_SURFACE"] == [(8, 6)]
    assert passes["SURFACE_TO_SURFACE"] == passes["AUTOMATIC_SURFACE_TO_SURFACE"] == [(8, 6), (8, 6)]
    assert passes["AUTOMATIC_SINGLE_SURFACE"] == [(16, 12)]


def test_a_single_surface_has_no_second_side(deck):
    with pytest.raises(
        DeckError, match=r"\*CONTACT_AUTOMATIC_SINGLE_SURFACE: SURFB = 1: a single surface has no"
    ):
        build(bricks(deck, "AUTOMATIC_SINGLE_SURFACE", "0,1"))


@pytest.mark.parametrize(
    ("keyword", "cards"),
    [
        ("NODES_TO_SURFACE", "2,1,3,3"),
        ("SURFACE_TO_SURFACE", "2,1,3,3"),
        ("AUTOMATIC_NODES_TO_SURFACE", "2,1,3,3"),
        ("AUTOMATIC_SINGLE_SURFACE", "0"),
    ],
)
def test_bricks_meet_at_their_faces_and_keep_their_momentum(deck, keyword, cards):
    model = build(bricks(deck, keyword, cards))
    s, contact = model.state, contact_of(model)
    before, met = s.mass @ s.v, None
    show = {name: probe(model, contact=1, component=name) for name in ("z-force", "energy", "area", "nodes")}
    on_node = probe(model, contact=1, component="z-force", node=11)
    most = dict.fromkeys(show, 0.0)
    for state in steps(model):
        if contact.force.any() or show["nodes"]() > 0:
            met = state.t if met is None else met
            most = {name: max(most[name], value()) for name, value in show.items()}
            if keyword == "NODES_TO_SURFACE":  # four nodes share the force alike
                assert on_node() == pytest.approx(show["z-force"]() / 4.0, rel=1e-9)
    assert met - s.dt <= 0.1 <= met
    np.testing.assert_allclose(s.mass @ s.v, before, atol=1e-12 * abs(before[2]))
    assert s.v[8:, 2].mean() > s.v[:8, 2].mean()  # and they part
    assert most["nodes"] == 4.0
    assert most["area"] == pytest.approx(4 * 3 * 0.25 / 4.0)  # each corner has a quarter of three faces
    assert most["energy"] > 0.0


def test_nodes_that_begin_inside_are_moved_out_by_an_automatic_contact(deck):
    model = build(bricks(deck, "AUTOMATIC_NODES_TO_SURFACE", "2,1,3,3", gap=-0.002))
    np.testing.assert_allclose(model.state.x[8:12, 2], 1.0, atol=1e-12)
    np.testing.assert_allclose(model.x0[8:12, 2], 1.0, atol=1e-12)
    assert model.facts["Initial penetrations of contact 1"].startswith(
        "4 nodes, the deepest 11 by 0.002: moved"
    )


def test_nodes_that_begin_inside_are_kept_without_force_by_ignore(deck):
    cards = "2,1,3,3\n\n\n\n\n,1"
    model = build(bricks(deck, "NODES_TO_SURFACE", cards, gap=-0.002))
    np.testing.assert_allclose(model.state.x[8:12, 2], 0.998, atol=1e-12)
    assert "kept as offsets of the gap" in model.facts["Initial penetrations of contact 1"]
    next(iter(steps(model)))
    assert not contact_of(model).force.any()
    with pytest.raises(DeckError, match=r"SURFA = 2: node 11 begins 0.002 behind the surface"):
        build(bricks(deck, "NODES_TO_SURFACE", "2,1,3,3", gap=-0.002))


def test_channels_of_a_contact_that_are_not_there_are_refused(deck):
    model = build(bricks(deck, "NODES_TO_SURFACE", "2,1,3,3"))
    with pytest.raises(
        ProbeError, match=r"no 'pressure' of a contact; there are: x-force, .*friction energy"
    ):
        probe(model, contact=1, component="pressure")
    with pytest.raises(ProbeError, match="no node 1 among the tracked nodes of contact 1"):
        probe(model, contact=1, component="z-force", node=1)
    with pytest.raises(ProbeError, match="no 'area' on a node in contact"):
        probe(model, contact=1, component="area", node=11)


@pytest.mark.parametrize("speed", [0.5, 200.0])
def test_a_node_that_goes_too_deep_for_an_automatic_contact_is_reported(wall_and, speed):
    # Half the thickness is 0.05, PENMAX 0.4 of it all: at 200 the node is through within a step, and never held.
    ball = f"*NODE\n15,0.1,0.2,0.5\n*ELEMENT_MASS\n9,15,1.0\n*INITIAL_VELOCITY_NODE\n15,0,0,-{speed}\n"
    cards = "*SET_NODE_LIST\n2\n15\n*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,1,4,3\n\n\n"
    model = wall_and(ball + cards, end=1.0 / speed)
    z = probe(model, node=15, component="z-coordinate")
    ratio, stored = probe(model, energy="ratio"), probe(model, contact=1, component="energy")
    assert limits_reached(model) == {}
    held, ratios = zip(*((contact_of(model).nodes_in_contact(), ratio()) for _ in steps(model)), strict=True)
    assert any(held) == (speed < 100.0)
    np.testing.assert_allclose(ratios, 1.0, rtol=1e-6)
    assert stored() == pytest.approx(0.0, abs=1e-6)  # at 0.5 each side has had 1e-4
    lost = probe(model, contact=1, component="released energy")
    assert lost() == probe(model, energy="released")()
    assert z() < -0.4
    assert limits_reached(model) == {
        "Let through by contact 1": "one node, first of them 15: deeper than PENMAX or PENCHK allows"
    }


def test_a_node_without_an_element_touches_with_no_area(wall_and):
    ball = "*NODE\n5,0,0,0.0\n*ELEMENT_MASS\n105,5,1.0\n*SET_NODE_LIST\n2\n5\n*INITIAL_VELOCITY\n\n0,0,-1\n"
    model = wall_and(ball + "*CONTACT_NODES_TO_SURFACE\n2,1,4,3\n\n\n", end=0.01)
    nodes, area = (probe(model, contact=1, component=what) for what in ("nodes", "area"))
    *_, _ = steps(model)
    assert (nodes(), area()) == (1, 0.0)


def test_the_reaction_at_one_support(wall_and):
    model = wall_and("*BOUNDARY_SPC_NODE\n1,,1,1,1,1,1,1\n*LOAD_NODE_POINT\n1,3,1,2.5\n")
    reaction = probe(model, support=1, component="z-force")
    *_, _ = steps(model)
    assert reaction() == pytest.approx(-2.5)
    with pytest.raises(ProbeError, match="no support at node 99"):
        probe(model, support=99, component="z-force")


def test_a_contact_of_solids_is_drawn_by_its_segments(deck):
    found = bricks(deck, "SURFACE_TO_SURFACE", "2,1,3,3")
    ((tracked, segments),) = view_of(found).contacts
    assert tracked.size == 16
    assert segments.shape == (12, 4)
