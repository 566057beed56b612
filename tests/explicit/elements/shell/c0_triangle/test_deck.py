"""Triangles of a deck: N4 = N3 or none, beside quadrilaterals in one part; thinning, plasticity, loads; refusals."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe
from vmharness.mesh.elements import shells

SHEET = "*NODE\n5,0.0,0.0,3.0\n6,1.0,0.0,3.0\n7,1.0,1.0,3.0\n8,0.0,1.0,3.0\n"
HALVES = "*ELEMENT_SHELL\n2,{pid},5,6,7,7\n3,{pid},7,8,5\n"  # the second without N4
STEEL = "*PART\np\n2,1,2\n*MAT_PLASTIC_KINEMATIC\n2,1e-4,3.0,0.3,1e-6\n\n"


def triangles(model):
    return [force for force in model.forces if force.name.startswith("triangles")]


def test_a_part_of_both_makes_two_forces(wall_and):
    """Masses rho t A / 3 with the wall's rho 1e-4 and t 0.1; all can be probed and drawn."""
    model = wall_and(SHEET + HALVES.format(pid=1))
    (block,) = triangles(model)
    assert block.eid.tolist() == [2, 3]
    assert block.pid == 1
    assert model.ids[block.nodes].tolist() == [[5, 6, 7], [7, 8, 5]]
    assert model.state.mass[4:] == pytest.approx(1e-4 * 0.1 / 6 * np.array([2, 1, 2, 1]))
    for eid in (1, 2, 3):
        assert probe(model, shell=eid, component="thickness")() == pytest.approx(0.1)


def test_faces_repeat_the_third_corner(deck):
    read = deck(
        "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_ELASTIC\n1,1.0,3.0,0.0\n"
        + SHEET + HALVES.format(pid=1) + "*ELEMENT_SHELL_THICKNESS\n4,1,5,6,8,8\n0.1,0.2,0.6,9.0\n"
    )  # fmt: skip
    model = build(read)
    assert model.ids[shells(read, model).nodes].tolist() == [[5, 6, 7, 7], [7, 8, 5, 5], [5, 6, 8, 8]]
    assert probe(model, shell=4, component="thickness")() == pytest.approx(0.3)  # of its three nodes


def test_mass_scaling_takes_triangles_too(wall_and):
    """DT2MS = -1: no element steps below TSSFAC |DT2MS| = 0.9; the triangles' mass grows as their step does, squared."""
    free = wall_and(SHEET + HALVES.format(pid=1))
    natural = triangles(free)[0].steps(free.x0).min()
    model = wall_and("*CONTROL_TIMESTEP\n,0.9,,,-1.0,,,1\n" + SHEET + HALVES.format(pid=1))
    (block,) = triangles(model)
    block.add(model.state)
    assert block.stable_step() == pytest.approx(1.0)
    assert model.state.mass[4:].sum() == pytest.approx(1e-4 * 0.1 / natural**2)
    assert {"Mass added to shells of part 1", "Mass added to triangles of part 1"} <= model.facts.keys()


@pytest.mark.parametrize("esort", [0, 1])
@pytest.mark.parametrize("istupd", [0, 1])
def test_plastic_flow_and_thickness(wall_and, istupd, esort):
    """Equal strains far beyond yield: the plastic strain is twice the strain, and the sheet thins by it (ISTUPD)."""
    model = wall_and(f"*CONTROL_SHELL\n20.0,{esort},,{istupd}\n" + STEEL + SHEET + HALVES.format(pid=2))
    strain = 2e-4
    model.state.v[[5, 6], 0] = model.state.v[[6, 7], 1] = 0.2  # from -dt/2 on
    model.state.dt = 1e-3
    triangles(model)[0].add(model.state)
    for eid in (2, 3):
        assert probe(model, shell=eid, component="plastic-strain")() == pytest.approx(2 * strain, rel=0.02)
        thinned = 0.1 * (1 - 2 * strain) if istupd else 0.1
        assert probe(model, shell=eid, component="thickness")() == pytest.approx(thinned, rel=1e-6)


def test_a_strip_under_sudden_load_stretches_by_twice_the_static_amount(wall_and):
    """u = F/k (1 - cos omega t), k = E t b / L, nu = 0: two triangles have just the stiffness of the strip."""
    held = "*BOUNDARY_SPC_NODE\n5,0,1,1,1,1,1,1\n8,0,1,1,1,1,1,1\n6,0,0,1,1,1,1,1\n7,0,0,1,1,1,1,1\n"
    mass = "*ELEMENT_MASS\n11,6,1.0\n12,7,1.0\n"
    load = "*LOAD_NODE_POINT\n6,1,1,1e-5\n7,1,1,1e-5\n"
    omega = np.sqrt(3.0 * 0.1 / 2.0)
    model = wall_and(SHEET + HALVES.format(pid=1) + held + mass + load, end=np.pi / omega)
    for state in steps(model):
        u = state.x[[5, 6], 0] - 1.0
    assert u == pytest.approx(2 * 2e-5 / (3.0 * 0.1), rel=1e-3)
    assert probe(model, energy="ratio")() == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        (
            "*ELEMENT_SHELL\n2,1,5,6,6,7\n",
            r"\*ELEMENT_SHELL: N1 = 5: has a node twice; a triangle repeats its third",
        ),
        ("*ELEMENT_SHELL\n2,1,5,6,5,5\n", r"\*ELEMENT_SHELL: N1 = 5: has a node twice"),
        ("*ELEMENT_SHELL\n2,1,5,6,99,99\n", r"\*ELEMENT_SHELL: N3 = 99: no \*NODE 99"),
    ],
)
def test_what_is_refused(wall_and, keywords, message):
    with pytest.raises(DeckError, match=message):
        wall_and(SHEET + keywords)
