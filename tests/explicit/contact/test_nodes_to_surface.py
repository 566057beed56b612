"""*CONTACT_NODES_TO_SURFACE: stiffness, balance, sides, errors."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe

K_WALL = math.sqrt(2.0)  # K A / d of the wall, before SLSFAC

FREE_PLATE = """*NODE
11,-1.0,-1.0,5.0
12,1.0,-1.0,5.0
13,1.0,1.0,5.0
14,-1.0,1.0,5.0
*PART
plate
2,1,1
*ELEMENT_SHELL
2,2,11,12,13,14
"""


def ball(x=0.0, y=0.0, z=0.001, mass=0.5, nid=5):
    return f"*NODE\n{nid},{x},{y},{z}\n*ELEMENT_MASS\n{nid + 100},{nid},{mass}\n*SET_NODE_LIST\n2\n{nid}\n"


def contact(surfb="1", kind=3, slsfac=1.0, sfsa="", sfsb="", orien=""):
    return (
        f"*CONTROL_CONTACT\n{slsfac},,,,,,{orien}\n\n"
        f"*CONTACT_NODES_TO_SURFACE\n2,{surfb},4,{kind}\n\n{sfsa},{sfsb}\n"
    )


def falling(vz=-1.0, nid=5):
    return f"*INITIAL_VELOCITY_NODE\n{nid},,,{vz}\n"


def contact_of(model):
    """The only contact of a model."""
    return next(force for force in model.forces if isinstance(force, Contact))


def deepest(model):
    """Force on the ball, depth and reactions at the supports, at the deepest point."""
    best = (0.0, 0.0, np.zeros(4))
    for s in steps(model):
        depth = -s.x[4, 2]
        if depth > best[1]:
            best = (contact_of(model).force[2], depth, model.constraints[0].reaction[:4, 2].copy())
        elif s.v[4, 2] > 0.0:
            break
    return best


@pytest.mark.parametrize(("slsfac", "sfsb"), [(1.0, ""), (0.1, ""), (0.5, "3.0")])
def test_stiffness_is_slsfac_sfsb_k_a_over_d(wall_and, slsfac, sfsb):
    model = wall_and(ball() + contact(slsfac=slsfac, sfsb=sfsb) + falling(), end=10.0)
    force, depth, _ = deepest(model)
    assert force / depth == pytest.approx(slsfac * float(sfsb or 1.0) * K_WALL, rel=1e-13)


@pytest.mark.parametrize(("xi", "eta"), [(0.0, 0.0), (0.5, -0.25), (-0.9, 0.9), (1.0, 1.0)])
def test_reactions_share_the_force_by_the_shape_functions(wall_and, xi, eta):
    model = wall_and(ball(x=xi, y=eta) + contact() + falling(), end=10.0)
    force, _, reactions = deepest(model)
    shares = [(1 + a * xi) * (1 + b * eta) / 4 for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    np.testing.assert_allclose(reactions, np.array(shares) * force, atol=1e-13 * force)


def test_a_node_beside_the_segment_passes_by(wall_and):
    model = wall_and(ball(x=1.05) + contact() + falling(), end=0.5)
    *_, last = steps(model)
    assert last.x[4, 2] == pytest.approx(0.001 - last.t)
    assert not contact_of(model).force.any()


def test_a_node_that_comes_from_behind_an_edge_is_not_caught(wall_and):
    # It passes below the plane beside the segment, then slides under it.
    path = "*INITIAL_VELOCITY_NODE\n5,-2.0,0.0,-1.0\n"
    model = wall_and(ball(x=1.5, z=0.1) + contact() + path, end=0.6)
    for _ in steps(model):
        assert not contact_of(model).force.any()
    assert model.state.x[4, 0] < 0.5
    assert model.state.x[4, 2] < -0.4


def test_part_input_is_turned_to_face_the_nodes(wall_and):
    # The wall's own normal is +z; a ball that comes from below is met all the same.
    model = wall_and(ball(z=-0.001) + contact() + falling(vz=1.0), end=10.0)
    largest = max(-contact_of(model).force[2] for _ in steps(model))
    assert largest > 0.0
    assert model.state.v[4, 2] == pytest.approx(-1.0, rel=1e-3)  # thrown back


def test_segment_set_is_one_sided_as_given_unless_orien_is_2(wall_and):
    turned = "*SET_SEGMENT\n7\n4,3,2,1\n"
    with pytest.raises(DeckError, match=r"node 5 begins 0\.001 behind the surface"):
        wall_and(ball() + turned + contact(surfb="7", kind=0) + falling())
    model = wall_and(ball() + turned + contact(surfb="7", kind=0, orien=2) + falling(), end=10.0)
    assert deepest(model)[0] > 0.0


def test_a_segment_without_a_shell_is_an_error(wall_and):
    wrong = "*SET_SEGMENT\n7\n1,2,3,5\n"
    with pytest.raises(
        DeckError, match=r"\*SET_SEGMENT: N1 = 1: no shell and no face of a solid has the nodes"
    ):
        wall_and(ball() + wrong + contact(surfb="7", kind=0))


def test_free_bodies_keep_momentum_and_energy(wall_and):
    # A ball strikes a free plate off its centre: nothing is lost, nothing comes from nowhere.
    text = FREE_PLATE + ball(x=0.3, y=-0.2, z=5.001, mass=0.01) + contact(surfb="2", slsfac=0.05)
    model = wall_and(text + falling(), end=1.0)
    s = model.state
    initial = energy.kinetic(s)
    stored = energy.stored(model.forces)
    momentum0 = (s.mass[:, None] * s.v).sum(axis=0)
    touched, worst = False, 0.0
    for state in steps(model):
        touched |= bool(contact_of(model).force.any())
        total = energy.kinetic(state) + sum(a[0] for a in stored)
        worst = max(worst, abs(total / initial - 1.0))
    momentum = (s.mass[:, None] * s.v).sum(axis=0)
    assert touched
    assert not contact_of(model).force.any()  # and it has left again
    np.testing.assert_allclose(momentum[2], momentum0[2], rtol=1e-12)
    assert worst < 2e-3


@pytest.mark.parametrize("z", [0.0, -1e-10, -2e-9])
def test_a_node_behind_by_round_off_is_in_contact_from_the_start(wall_and, z):
    segment = "*SET_SEGMENT\n7\n1,2,3,4\n"
    model = wall_and(ball(z=z) + segment + contact(surfb="7", kind=0) + "*LOAD_BODY_Z\n1,0.01\n", end=30.0)
    lowest = min(s.x[4, 2] for s in steps(model))
    assert -lowest == pytest.approx(
        2.0 * 0.5 * 0.01 / K_WALL, rel=1e-3
    )  # twice the static deflection, m g / k


def test_contacts_go_by_their_number(wall_and):
    named = contact().replace("*CONTACT_NODES_TO_SURFACE\n", "*CONTACT_NODES_TO_SURFACE_ID\n77,ball\n")
    model = wall_and(ball() + named)
    assert contact_of(model).number == 77
    probe(model, contact=77, component="z-force")
    with pytest.raises(ProbeError, match="no contact 1; there are: 77"):
        probe(model, contact=1, component="z-force")
    twice = named + named[named.index("*CONTACT") :]
    with pytest.raises(DeckError, match=r"CID = 77: another contact has this number"):
        wall_and(ball() + twice)


def test_corners_of_a_segment_do_not_touch_it(wall_and):
    corners = "*SET_NODE_LIST\n2\n1,2,3,4\n"
    model = wall_and(corners + contact(), end=0.1)
    for _ in steps(model):
        assert not contact_of(model).force.any()


def test_penopt_takes_the_softer_of_segment_and_tracked_shell(wall_and):
    # A free plate falls on the wall: both have the same K A/d, SFSA and SFSB scale one each.
    text = FREE_PLATE.replace("5.0", "0.001") + "*SET_NODE_LIST\n2\n11,12,13,14\n"
    for sfsa, sfsb, factor in ((1.0, 0.25, 0.25), (0.5, 1.0, 0.5)):
        model = wall_and(text + contact(sfsa=sfsa, sfsb=sfsb), end=1.0)
        (one,) = contact_of(model).passes
        k = np.minimum(one.segments["penalty"], one.nodes["penalty"])
        np.testing.assert_allclose(k, factor * K_WALL)


def test_unsupported_options_name_field_and_value(wall_and):
    with pytest.raises(
        DeckError, match=r"deck.k:\d+: \*CONTACT_NODES_TO_SURFACE: SABOXID = 3: only 0 is supported"
    ):
        wall_and(ball() + contact().replace("2,1,4,3\n\n", "2,1,4,3,3\n\n"))
    with pytest.raises(DeckError, match=r"SURFA = 9: .*no \*SET_NODE.* with SID = 9; defined: 2"):
        wall_and(ball() + contact().replace("2,1,4,3\n", "9,1,4,3\n"))
