"""Rigid bodies among elements: the same by any card, gravity, springs between them, deformable parts on them."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

CORNERS = """*NODE
{first},0.0,0.0,0.0
{1},2.0,0.0,0.0
{2},2.0,1.0,0.0
{3},0.0,1.0,0.0
{4},0.0,0.0,0.5
{5},2.0,0.0,0.5
{6},2.0,1.0,0.5
{7},0.0,1.0,0.5
"""
NODAL = """*CONSTRAINED_NODAL_RIGID_BODY
7,0,4
*SET_NODE_LIST_GENERATE
4
1,8
*ELEMENT_MASS
""" + "".join(f"{nid},{nid},1.0\n" for nid in range(1, 9))
PUSHED = "*LOAD_NODE_POINT\n3,3,1,0.7\n6,1,1,-0.4\n"
SPIN = "*INITIAL_VELOCITY_GENERATION\n0,2,1.5,0.1,0.2,0.3\n1.0,2.0,3.0,1.0,1.0,0.5\n"


def path(model):
    return np.array([s.x[:8].copy() for s in steps(model)])


def nodes_of(block):
    return block[block.index("*NODE") :]


def test_a_nodal_rigid_body_moves_as_the_part_does(space, block):
    part = path(space(block + PUSHED + SPIN, end=2.0))
    nodal = path(space(nodes_of(block) + NODAL + PUSHED + SPIN, end=2.0))
    np.testing.assert_allclose(nodal, part, rtol=0, atol=1e-12)
    assert np.abs(part[-1] - part[0]).max() > 1.0


def test_given_inertia_that_is_the_sum_moves_as_the_sum_does(space, block):
    given = block.replace(
        "*PART\nblock\n7,7,7\n", "*PART_INERTIA\nblock\n7,7,7\n1.0,0.5,0.25,8.0\n2.5,0.0,0.0,8.5,0.0,10.0\n\n"
    )
    turned = block.replace(
        "*PART\nblock\n7,7,7\n",
        "*PART_INERTIA\nblock\n7,7,7\n1.0,0.5,0.25,8.0,1\n8.5,0.0,0.0,10.0,0.0,2.5\n\n0.0,1.0,0.0,0.0,0.0,1.0\n",
    )  # local x, y, z along global y, z, x
    assert "INERTIA" in given and "INERTIA" in turned  # noqa: PT018
    for text in (given, turned):
        np.testing.assert_allclose(
            path(space(text + PUSHED, end=2.0)), path(space(block + PUSHED, end=2.0)), rtol=0, atol=1e-12
        )


def test_nodal_velocities_become_the_rigid_motion_of_the_same_momentum(space, bodies, block):
    model = space(block + "*INITIAL_VELOCITY_NODE\n3,0.0,0.0,8.0\n", end=1.0)
    c, b = model.centre(7), bodies(model)
    np.testing.assert_allclose(model.state.v[c], [0.0, 0.0, 1.0], atol=1e-14)
    np.testing.assert_allclose(b.L[0], [4.0, -8.0, 0.0], atol=1e-13)  # r x m v, r = (1, 1/2, -1/4)


def test_cards_that_give_velocities_rule_in_their_order(space, block, free):
    model = space(free(wx=1.0) + "*INITIAL_VELOCITY\n0\n5.0\n")
    assert model.state.v[model.centre(3)].tolist() == [0, 0, 0]
    assert model.state.omega[model.centre(3)].tolist() == [1, 0, 0]
    model = space(free(wx=1.0) + "*INITIAL_VELOCITY_RIGID_BODY\n3,1.0,2.0,3.0,4.0,5.0,6.0\n")
    assert model.state.v[model.centre(3)].tolist() == [1, 2, 3]
    assert model.state.omega[0].tolist() == [4, 5, 6]


@pytest.mark.parametrize("which", ["block", "given"])
def test_bodies_fall_as_masses_do_wherever_their_mass_comes_from(space, bodies, block, free, which):
    text, number = (block, 7) if which == "block" else (free(wy=3.0), 3)
    model = space(text + "*LOAD_BODY_Z\n1,9.81\n", end=1.0)
    z, v = (probe(model, rigid=number, component=f"z-{what}") for what in ("displacement", "velocity"))
    L = bodies(model).L.copy()
    for s in steps(model):
        assert z() == pytest.approx(-9.81 * s.t**2 / 2, abs=1e-12)
        assert v() == pytest.approx(-9.81 * s.t, abs=1e-12)
    np.testing.assert_allclose(bodies(model).L, L, atol=1e-14)


def test_extra_nodes_bring_their_mass_and_merged_parts_are_one_body(space, bodies, block):
    extra = "*NODE\n20,5.0,0.5,0.25\n*ELEMENT_MASS\n20,20,8.0\n*CONSTRAINED_EXTRA_NODES_NODE\n7,20\n"
    second = "*PART\nsecond\n8,7,7\n*SECTION_SHELL\n8,2\n1.0\n*PART\nplate\n9,8,7\n*ELEMENT_SHELL\n5,9,21,22,23,24\n"
    second += "*NODE\n21,4.5,0.0,0.25\n22,5.5,0.0,0.25\n23,5.5,1.0,0.25\n24,4.5,1.0,0.25\n"
    model = space(block + extra)
    np.testing.assert_allclose(model.state.x[model.centre(7)], [3.0, 0.5, 0.25])
    np.testing.assert_allclose(sorted(bodies(model).principal[0]), [2.5, 8.5 + 4.0 * 16.0, 10.0 + 4.0 * 16.0])
    model = space(block + second.replace("*PART\nsecond\n8,7,7\n", "") + "*CONSTRAINED_RIGID_BODIES\n7,9\n")
    assert bodies(model).numbers.tolist() == [7]
    assert model.state.mass[model.centre(7)] == pytest.approx(16.0)
    np.testing.assert_allclose(model.state.x[model.centre(7)], [3.0, 0.5, 0.25])


PAIR = """*SECTION_SOLID
3,1
*MAT_RIGID
3,1.0,100.0,0.3


*PART_INERTIA
one
3,3,3
0.0,0.0,0.0,2.0
1.0,0.2,0.0,2.0,0.0,2.5
0.1,0.0,0.0,0.5,0.0,0.3
*PART_INERTIA
other
4,3,3
3.0,0.0,0.0,1.0
0.5,0.0,0.1,0.6,0.0,0.7

*NODE
1,1.0,0.5,0.0
2,2.5,0.0,0.5
3,1.0,-0.5,0.2
4,2.5,0.4,0.0
*CONSTRAINED_EXTRA_NODES_NODE
3,1
3,3
4,2
4,4
*PART
springs
9,9,9
*SECTION_DISCRETE
9,0

*MAT_SPRING_ELASTIC
9,40.0
*ELEMENT_DISCRETE
1,9,1,2,0,1.0,0,0.1
2,9,3,4,0,0.5,0,0.0
"""


def test_springs_between_bodies_keep_momentum_and_angular_momentum(space, bodies):
    model = space(PAIR, end=20.0, step=1e-2)
    s, b, c = model.state, bodies(model), [model.centre(3), model.centre(4)]
    found, total = [], []
    (internal,) = [f.energy["spring and damper"] for f in model.forces]
    for _ in steps(model):
        # L_{n+1/2} with r x p: at t_n + dt/2, exactly what the loop keeps; here at t_n with v_{n-1/2}.
        p = s.mass[c][:, None] * s.v[c]
        if s.dt:
            found.append([*p.sum(axis=0), *(np.cross(s.x[c], p).sum(axis=0) + b.L.sum(axis=0))])
        total.append(model.kinetic() + internal[0])
    found = np.array(found)
    assert np.abs(found - found[0]).max() < 1e-12 * len(found) ** 0.5
    assert np.abs(np.array(total) / total[0] - 1.0).max() < 2e-3
    assert np.abs(b.angle).max() > 1.0


def test_the_step_of_springs_on_massless_nodes_is_that_of_the_bodies(deck):
    # A spring along x from the ground to a node of a body, in line with its centre: 2 sqrt(M/k).
    text = """*KEYWORD\n*CONTROL_TERMINATION\n10.0\n*SECTION_SOLID\n3,1\n*MAT_RIGID\n3,1.0,100.0,0.3\n\n
*PART_INERTIA\none\n3,3,3\n0.0,0.0,0.0,2.0\n1.0,0.0,0.0,2.0,0.0,2.5\n\n
*NODE\n1,{x},{y},0.0\n2,5.0,{y},0.0,7,7\n*CONSTRAINED_EXTRA_NODES_NODE\n3,1\n*PART\nspring\n9,9,9
*SECTION_DISCRETE\n9,0\n\n*MAT_SPRING_ELASTIC\n9,50.0\n*ELEMENT_DISCRETE\n1,9,1,2\n*CONTROL_TIMESTEP\n0.0,1.0\n"""
    for x, y, mass in ((1.0, 0.0, 1 / (1 / 2 + 1 / 2.0)), (0.0, 0.5, 1 / (1 / 2 + 0.25 / 1.0))):
        model = build(deck(text.format(x=x, y=y)))
        next(steps(model))
        assert model.next_step() == pytest.approx(2 * math.sqrt(mass / 50.0), rel=1e-9)


def test_bodies_alone_have_the_step_that_their_elements_would_have(deck, block):
    text = "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n"
    model = build(deck(text + block))
    next(steps(model))
    elastic = build(deck(text + block.replace("*MAT_RIGID", "*MAT_ELASTIC").replace("\n\n\n", "\n")))
    next(steps(elastic))
    assert model.next_step() == pytest.approx(elastic.next_step(), rel=1e-12)
    assert "nothing else limits the step" in model.facts["Step of rigid bodies"]


def test_a_body_without_elements_needs_a_step(deck):
    body = "*CONSTRAINED_NODAL_RIGID_BODY\n1,0,1\n*SET_NODE_LIST\n1\n1,2\n*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n"
    model = build(deck("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n1,0.0\n2,1.0\n" + body))
    with pytest.raises(SolverError, match=r"no element limits the time step.*LCTM"):
        list(steps(model))


def test_a_body_that_turns_too_far_in_a_step_is_an_error(space, free):
    with pytest.raises(SolverError, match=r"a rigid body turns by 1.2 rad in a step of 0.01"):
        list(steps(space(free(wx=120.0))))


def test_two_bodies_do_not_share_a_node_and_none_is_without_mass(space, block):
    with pytest.raises(DeckError, match=r"node 3 belongs to rigid body 7 as well; merge them"):
        space(block + "*CONSTRAINED_NODAL_RIGID_BODY\n8,0,4\n*SET_NODE_LIST\n4\n3\n")
    with pytest.raises(DeckError, match=r"PID = 8: a rigid body without mass"):
        space(block + "*CONSTRAINED_NODAL_RIGID_BODY\n8,0,4\n*SET_NODE_LIST\n4\n9\n*NODE\n9,0,0,9\n")


SCALED = """*KEYWORD
*CONTROL_TERMINATION
1.0
*CONTROL_TIMESTEP
,,,,-1e3,,,{ms1st}
*PART
sheet
1,1,1
*SECTION_SHELL
1,2
0.1
*MAT_ELASTIC
1,1.0,3.0,0.0
*ELEMENT_SHELL
1,1,1,2,3,4
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
*CONSTRAINED_NODAL_RIGID_BODY
9,0,2
*SET_NODE_LIST
2
1,2
"""


def test_mass_of_the_nodes_of_a_body_is_scaled_at_the_beginning_alone(deck):
    model = build(deck(SCALED.format(ms1st=1)))
    assert model.state.mass[model.centre(9)] == pytest.approx(model.state.mass[2:4].sum(), rel=1e-12)
    assert model.state.mass[2] > 1e3 * 0.025
    with pytest.raises(
        DeckError, match=r"PID = 9: its node 1 is one of elements whose mass is scaled during the run"
    ):
        build(deck(SCALED.format(ms1st=0)))


def test_inertia_is_given_to_rigid_parts_only(space, block):
    text = block.replace(
        "*PART\nblock\n7,7,7\n",
        "*PART_INERTIA\nblock\n7,7,8\n,,,1.0\n1.0,,,1.0,,1.0\n\n*MAT_ELASTIC\n8,1.0,1.0\n",
    )
    with pytest.raises(DeckError, match=r"MID = 8: \*PART_INERTIA is for parts of \*MAT_RIGID"):
        space(text)


def test_a_part_load_takes_the_whole_body_or_none(space, block):
    loads = "*LOAD_BODY_PARTS\n4\n*LOAD_BODY_Z\n1,9.81\n*SET_PART_LIST\n4\n{}\n"
    model = space(block + loads.format(7))
    next(steps(model))
    assert model.state.a[model.centre(7), 2] == -9.81
    deformable = (
        nodes_of(block)
        + NODAL
        + "*PART\nbox\n6,6,6\n*SECTION_SOLID\n6,1\n*MAT_ELASTIC\n6,1.0,1.0\n*ELEMENT_SOLID\n1,6\n1,2,3,4,5,6,7,8\n"
    )
    with pytest.raises(
        DeckError, match=r"PID = 7: \*LOAD_BODY_Z acts on parts that have nodes of this rigid body"
    ):
        space(deformable + loads.format(6))


CANTILEVER = """*KEYWORD
*CONTROL_TERMINATION
0.02
*PART
strip
1,1,1
*SECTION_SHELL
1,2,0.833333,3
0.01
*MAT_ELASTIC
1,1000.0,1e9,0.3
*DEFINE_CURVE
1
0.0,1.0
1.0,1.0
*LOAD_NODE_SET
2,3,1,0.5
*SET_NODE_LIST
2
7,14
"""


def strip(root):
    """A strip of six shells, of length 0.6 and width 0.1, with its root at x = 0."""
    lines = ["*NODE"]
    for j in range(2):
        for i in range(7):
            nid, codes = 1 + i + 7 * j, ",7,7" if i == 0 and root == "supports" else ""
            lines.append(f"{nid},{0.1 * i},{0.1 * j},0.0{codes}")
    lines.append("*ELEMENT_SHELL")
    lines += [f"{i},1,{i},{i + 1},{i + 8},{i + 7}" for i in range(1, 7)]
    if root == "block":
        lines += ["*NODE", "21,-0.1,0.0,0.0", "22,-0.1,0.1,0.0"]
        lines += [
            "*PART",
            "block",
            "2,1,2",
            "*MAT_RIGID",
            "2,1e3,1e9,0.3",
            "1,7,7",
            "",
            "*ELEMENT_SHELL",
            "9,2,21,1,8,22",
        ]
    return CANTILEVER + "\n".join(lines) + "\n"


def test_a_cantilever_on_a_rigid_block_is_clamped(deck):
    found = []
    for root in ("supports", "block"):
        model = build(deck(strip(root)))
        tip = probe(model, node=7, component="z-displacement")
        found.append([(s.t, tip()) for s in steps(model)])
        force = (
            probe(model, support="all", component="z-force")
            if root == "supports"
            else probe(model, rigid=2, component="z-force")
        )
        found[-1].append((force(), 0.0))
    np.testing.assert_allclose(found[1], found[0], rtol=1e-9, atol=1e-15)
    assert max(abs(z) for _, z in found[0]) > 1e-4


def test_a_free_strip_with_a_rigid_end_keeps_its_momentum(deck):
    text = (
        strip("block")
        .replace("1,7,7\n\n", "\n\n")
        .replace("*LOAD_NODE_SET\n2,3,1,0.5\n", "*INITIAL_VELOCITY_NODE\n7,,,20.0\n14,,,15.0\n")
    )
    model = build(deck(text))
    model.step_factor = 0.1
    s, b = model.state, next(c for c in model.constraints if c.name == "rigid bodies").bodies
    found, energies = [], []
    internal = [account for force in model.forces for account in force.energy.values()]
    for _ in steps(model):
        p = s.mass[:, None] * s.v
        own = s.inertia[:, None] * s.omega
        if s.dt:
            found.append([*p.sum(axis=0), *(np.cross(s.x, p) + own).sum(axis=0) + b.L.sum(axis=0)])
        energies.append(model.kinetic() + sum(account[0] for account in internal))
    found = np.array(found)
    assert np.abs(found - found[0]).max() < 1e-12 * np.abs(found[0]).max() * len(found) ** 0.5
    assert np.abs(np.array(energies) / energies[0] - 1.0).max() < 5e-3
    assert np.abs(b.angle).max() > 1e-3
