"""A rigid plate that falls on the wall of the shared fixtures: it bounces, and turns if it falls aslant."""

import numpy as np
import pytest

from vmharness.explicit import energy
from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe
from vmharness.explicit.rigid.constraints import RigidBodies

RIGID, ELASTIC = "*MAT_RIGID\n5,1.0,300.0,0.0\n\n\n", "*MAT_ELASTIC\n5,1.0,300.0,0.0\n"
PART = "*PART\nplate\n5,5,5\n"
GIVEN = "*PART_INERTIA\nplate\n5,5,5\n0.0,0.0,0.01,{mass},0\n{moment},0.0,0.0,{moment},0.0,{polar}\n0.0,0.0,-0.1\n"

PLATE = """{part}*SECTION_SHELL
5,2
0.1
{material}*ELEMENT_SHELL
5,5,15,16,17,18
*NODE
15,-0.5,-0.5,{low}
16,0.5,-0.5,{high}
17,0.5,0.5,{high}
18,-0.5,0.5,{low}
*SET_NODE_LIST
2
15,16,17,18
*CONTROL_CONTACT
1.0

*CONTACT_NODES_TO_SURFACE
2,1,4,3
,,,,{vdc}

{soft}
*INITIAL_VELOCITY
2
0.0,0.0,-0.1
"""
FORCE, SPEED = dict(contact=1, component="z-force"), dict(node=15, component="z-velocity")
LEVEL = dict(part=PART, material=RIGID, low=0.01, high=0.01, vdc=0.0, soft=0)
FLOOR = """*PART
floor
1,1,1
*SECTION_SHELL
1,2
0.1
{material}*ELEMENT_SHELL
1,1,1,2,3,4
*NODE
1,-1.0,-1.0,0.0{held}
2,1.0,-1.0,0.0{held}
3,1.0,1.0,0.0{held}
4,-1.0,1.0,0.0{held}
"""
FLOORS = [
    dict(material="*MAT_ELASTIC\n1,1.0,3.0,0.0\n", held=",7,7"),
    dict(material="*MAT_RIGID\n1,1.0,3.0,0.0\n1,7,7\n\n", held=""),
]


@pytest.mark.parametrize(("low", "high"), [(0.01, 0.01), (0.01, 0.11)])
def test_a_plate_bounces_with_the_energy_that_it_had(wall_and, low, high):
    model = wall_and(PLATE.format(**LEVEL | dict(low=low, high=high)), end=4.0, density=1e-6)
    (stored,) = energy.accounts(model.forces, "contact")
    v, spin = (probe(model, rigid=5, component=what) for what in ("z-velocity", "y-angular-velocity"))
    mass = 0.1 * np.hypot(1.0, high - low)
    force, impulse, before, fastest = probe(model, contact=1, component="z-force"), 0.0, 0.0, 0.0
    for s in steps(model):
        assert model.kinetic() + stored[0] == pytest.approx(0.5 * mass * 0.1**2, rel=1e-4)
        impulse += 0.5 * (before + force()) * s.dt
        before, fastest = force(), max(fastest, abs(spin()))
    assert force() == 0.0
    assert impulse == pytest.approx(mass * (v() + 0.1), rel=1e-4)
    # With all mass in the corners, the edges bounce each by itself: in between, one goes up and one down.
    assert v() == pytest.approx(0.1, rel=1e-3)
    assert fastest == pytest.approx(0.0 if low == high else 0.2, rel=0.02, abs=1e-9)
    assert np.ptp(model.state.lumped[4:8]) == pytest.approx(0.0, abs=1e-15)


BLOCK_ON_FLOOR = """*KEYWORD
*CONTROL_TERMINATION
20.0
*CONTROL_CONTACT
0.1

*PART
floor
1,1,1
block
7,7,7
*SECTION_SHELL
1,2,0.8333,2
0.3
*MAT_ELASTIC
1,0.3,1e4,0.3
*SECTION_SOLID
7,1
*MAT_RIGID
7,1.0,1000.0,0.3


*DEFINE_CURVE
1
0.0,1.0
1000.0,1.0
*LOAD_BODY_Z
1,10.0
*ELEMENT_SOLID
7,7,101,102,103,104,105,106,107,108
*SET_NODE_LIST
2
101,102,103,104
*CONTACT_NODES_TO_SURFACE
2,1,4,3
,,,,20.0

{soft}
"""


def on_a_floor(soft=""):
    """A rigid cube of side 1.2 and mass 1.728 above a square floor of 3 by 3 elastic shells, clamped at its edge."""
    text = BLOCK_ON_FLOOR.format(soft=soft)
    for i in range(4):
        for j in range(4):
            tc = 7 if i in (0, 3) or j in (0, 3) else 0
            text += f"*NODE\n{1 + i + 4 * j},{i - 1.5},{j - 1.5},0.0,{tc},{tc}\n"
    for i in range(3):
        for j in range(3):
            a = 1 + i + 4 * j
            text += f"*ELEMENT_SHELL\n{a},1,{a},{a + 1},{a + 5},{a + 4}\n"
    for k, (x, y, z) in enumerate(
        (x, y, z) for z in (0, 1.2) for x, y in ((-0.6, -0.6), (0.6, -0.6), (0.6, 0.6), (-0.6, 0.6))
    ):
        text += f"*NODE\n{101 + k},{x},{y},{z + 0.01}\n"
    return text


@pytest.mark.parametrize("soft", ["", "1"])
def test_a_block_with_contact_damping_comes_to_rest_on_an_elastic_floor(deck, soft):
    model = build(deck(on_a_floor(soft)))
    ratio, kinetic = (probe(model, energy=name) for name in ("ratio", "kinetic"))
    force = probe(model, contact=1, component="z-force")
    ratios, fastest = [], 0.0
    for _ in steps(model):
        ratios.append(ratio())
        fastest = max(fastest, kinetic())
    assert np.abs(np.array(ratios[100:]) - 1.0).max() < 1e-3
    assert kinetic() < 1e-10 * fastest
    assert force() == pytest.approx(1.728 * 10.0, rel=1e-9)


def test_damping_is_that_of_the_mass_at_the_nodes(wall_and):
    """A quarter of the plate on each of four springs k, beside a quarter of the shell: the rebound at zero force."""
    vdc, k, m, floor = 20.0, 2.0**0.5, 0.1 / 4, 0.1
    c = 0.02 * vdc * m * np.sqrt(k * (1 / m + 1 / floor))
    w, z = np.sqrt(k / m), c / (2.0 * np.sqrt(k * m))
    s = np.sqrt(1.0 - z**2)
    phase = np.pi - np.arctan2(2.0 * z * s, 1.0 - 2.0 * z**2)
    rebound = -0.1 * np.exp(-z / s * phase) * (np.cos(phase) - z / s * np.sin(phase))

    text = PLATE.format(**LEVEL | dict(vdc=vdc))
    text += "*CONTROL_TIMESTEP\n0.0,0.9,,,,2\n*DEFINE_CURVE\n2\n0.0,1e-3\n9.0,1e-3\n"
    model = wall_and(text, end=1.0, density=1.0)
    v, ratio = probe(model, rigid=5, component="z-velocity"), probe(model, energy="ratio")
    for _ in steps(model):
        pass
    assert 2.0 * np.pi / w < 1.0
    assert v() == pytest.approx(rebound, rel=2e-3)
    assert ratio() == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize("floor", FLOORS)
@pytest.mark.parametrize(("vdc", "soft"), [(20.0, 0), (0.0, 1), (20.0, 1)])
def test_damping_and_soft_1_feel_the_mass_of_a_rigid_plate_as_that_of_an_elastic_one(space, floor, vdc, soft):
    found = []
    for material in (RIGID, ELASTIC):
        plate = PLATE.format(**LEVEL | dict(material=material, vdc=vdc, soft=soft))
        model = space(FLOOR.format(**floor) + plate, end=3.0, step=0.002)
        force, v = (probe(model, **of) for of in (FORCE, SPEED))
        found.append((max(force() for _ in steps(model)), v()))
    most, speed = found[0]
    assert found[0] == pytest.approx(found[1], rel=1e-7)
    if soft:
        assert most > 1.0  # SOFSCL m/dt^2 at each of four nodes; the penalty gives 0.075
    if vdc:
        assert speed < 0.06  # 0.1 without damping


@pytest.mark.parametrize(("moment", "share"), [(0.05, 0.05), (0.0125, 0.0125)])
def test_nodes_of_a_body_of_given_inertia_have_shares_that_add_no_energy_to_any_motion(
    wall_and, moment, share
):
    # Four nodes at (+-1/2, +-1/2): in translation M v^2 = 0.2 v^2, in a turn about x I = 4 m/4.
    part = GIVEN.format(mass=0.2, moment=moment, polar=2.0 * moment)
    model = wall_and(PLATE.format(**LEVEL | dict(part=part)), density=1e-6)
    np.testing.assert_allclose(model.state.lumped[4:8], share, rtol=1e-12)


EXTRA = "*NODE\n21,{x},0.0,{z}\n*CONSTRAINED_EXTRA_NODES_NODE\n5,21\n*SET_NODE_LIST\n3\n21\n"
TOUCHING = "*CONTACT_NODES_TO_SURFACE\n3,1,4,3\n,,,,{vdc}\n\n{soft}\n"


@pytest.mark.parametrize("x", [0.0, 0.4])
def test_shares_of_extra_nodes_without_mass_add_no_energy_to_any_motion(wall_and, x):
    # Four corners of mass m = 0.025 and the extra node with their mean: the largest of sum m v^2 over M v^2 in a
    # translation is 5/4 where the node is in the middle, and 1 without it.
    text = PLATE.format(**LEVEL | dict(low=0.2, high=0.2))
    alone = wall_and(text + EXTRA.format(x=x, z=0.2), density=1e-6)
    np.testing.assert_allclose(alone.state.lumped[4:9], [0.025] * 4 + [0.0], rtol=1e-12)
    model = wall_and(text + EXTRA.format(x=x, z=0.2) + TOUCHING.format(vdc=0.0, soft=0), density=1e-6)
    shares = model.state.lumped[4:9]
    assert shares.min() == pytest.approx(shares.max(), rel=1e-12)
    if x == 0.0:
        assert shares[0] == pytest.approx(0.02, rel=1e-12)
    body = next(item for item in model.constraints if isinstance(item, RigidBodies)).bodies
    rng = np.random.default_rng(1)
    for _ in range(50):
        v, omega = rng.normal(size=(2, 3))
        nodes = ((v + np.cross(omega, body.arm)) ** 2).sum(axis=1)
        assert shares @ nodes <= 0.1 * v @ v + omega**2 @ body.principal[0] + 1e-12


@pytest.mark.parametrize(("vdc", "soft"), [(50.0, 0), (0.0, 1), (50.0, 1)])
def test_an_extra_node_without_mass_has_a_share_of_the_body_and_is_not_held(space, vdc, soft):
    """The node alone touches a floor of 1e5 times the body's mass: M on a spring k and damper c, to zero force."""
    step, mass = 0.01, 0.1
    floor = FLOOR.format(material="*MAT_ELASTIC\n1,1e5,3.0,0.0\n", held=",7,7")
    plate = PLATE.format(**LEVEL | dict(low=0.2, high=0.2)) + EXTRA.format(x=0.0, z=0.01)
    model = space(floor + plate + TOUCHING.format(vdc=vdc, soft=soft), end=4.0, step=step)
    share = model.state.lumped[8]
    k = 0.1 * share / step**2 if soft else 2.0**0.5
    z = 0.01 * vdc * np.sqrt(share / mass)
    s = np.sqrt(1.0 - z**2)
    phase = np.pi - np.arctan2(2.0 * z * s, 1.0 - 2.0 * z**2)
    rebound = -0.1 * np.exp(-z / s * phase) * (np.cos(phase) - z / s * np.sin(phase))

    ratio, v = probe(model, energy="ratio"), probe(model, rigid=5, component="z-velocity")
    force = probe(model, contact=2, component="z-force")
    most = max(force() for _ in steps(model))
    assert v() == pytest.approx(rebound, rel=5e-2)  # with SOFT = 1, w dt = 0.14
    assert ratio() == pytest.approx(1.0, abs=2e-2)
    if not vdc:
        assert most == pytest.approx(0.1 * np.sqrt(k * mass), rel=1e-2)
