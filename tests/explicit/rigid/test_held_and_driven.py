"""What CMO holds and prescribed motions drive, with reactions and work."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

RAMP = "*DEFINE_CURVE\n2\n0.0,0.0\n10.0,10.0\n"


@pytest.mark.parametrize("code", range(8))
def test_codes_of_cmo_hold_the_centre_and_the_rotations(space, constraint, held_block, code):
    axes = ["xyz".index(a) for a in ("", "x", "y", "z", "xy", "yz", "zx", "xyz")[code]]
    loads = "".join(f"*LOAD_RIGID_BODY\n7,{dof},1,{float(dof)}\n" for dof in (1, 2, 3, 5, 6, 7))
    model = space(held_block(code, code) + loads, end=0.2)
    s, held, c = model.state, constraint(model), model.centre(7)
    for _ in steps(model):
        moved, turned = s.x[c] - model.x0[c], held.bodies.angle[0]
        assert not moved[axes].any()
        assert not turned[axes].any()
        np.testing.assert_allclose(held.reaction[0, axes], [-(1.0 + a) for a in axes], rtol=1e-14)
    free = [a for a in range(3) if a not in axes]
    assert moved[free].all()
    assert turned[free].all()


def test_a_body_held_to_turn_about_z_has_moments_that_keep_its_tilted_axis(space, bodies):
    # Products of inertia: omega = w e_z, so that r = omega x I omega: (-I_yz, I_xz, 0) w^2.
    tilted = """*SECTION_SOLID\n3,1\n*MAT_RIGID\n3,1.0,100.0,0.3\n1,7,4\n\n*PART_INERTIA\nbody\n3,3,3
0.0,0.0,0.0,2.0\n2.0,0.0,0.3,3.0,0.4,4.0\n0.0,0.0,0.0,5.0,5.0,2.0\n*NODE\n1,0,0,0,7\n"""
    model = space(tilted, end=math.pi, step=1e-3)
    moment = [probe(model, rigid=3, component=f"{axis}-moment") for axis in "xyz"]
    angle, spin = (probe(model, rigid=3, component=f"z-{what}") for what in ("rotation", "angular-velocity"))
    for s in steps(model):
        t = angle()
        xz, yz = 0.3 * math.cos(t) - 0.4 * math.sin(t), 0.3 * math.sin(t) + 0.4 * math.cos(t)
        np.testing.assert_allclose([m() for m in moment], [-4.0 * yz, 4.0 * xz, 0.0], atol=1e-11)
        assert spin() == pytest.approx(2.0, rel=1e-11)
        assert t == pytest.approx(2.0 * s.t, rel=1e-11)
    assert model.kinetic() == pytest.approx(0.5 * 4.0 * 4.0, rel=1e-11)


@pytest.mark.parametrize("vad", [0, 1, 2])
def test_a_driven_rotation_follows_its_curve_and_its_work_is_kinetic_energy(
    space, constraint, held_block, vad
):
    text = held_block(7, 5) + RAMP + f"*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,5,{vad},2,0.5\n"
    model = space(text, end=2.0)
    angle, spin = (probe(model, rigid=7, component=f"x-{what}") for what in ("rotation", "angular-velocity"))
    moment = probe(model, motion=1, component="x-moment")
    exact = {0: lambda t: 0.25 * t**2, 1: lambda t: 0.5 * t**3 / 6, 2: lambda t: 0.5 * t}[vad]
    torque = {0: lambda t: 0.5, 1: lambda t: 0.5 * t, 2: lambda t: 0.0}[vad]
    (work,) = [
        a
        for a in energy.accounts(model.constraints, "external work")
        if a is constraint(model).energy["external work"]
    ]
    begun = None
    for s in steps(model):
        begun = model.kinetic() if begun is None else begun
        assert angle() == pytest.approx(exact(s.t), abs=1e-12 if vad != 1 else 1e-4)
        assert moment() == pytest.approx(2.5 * torque(s.t), abs=1e-9)
        assert work[0] == pytest.approx(model.kinetic() - begun, abs=2e-4 * (vad == 1) + 1e-9)
    assert spin() == pytest.approx({0: 0.5 * s.t, 1: 0.25 * s.t**2, 2: 0.5}[vad], rel=1e-4)


@pytest.mark.parametrize("vad", [0, 1, 2])
def test_a_driven_centre_follows_its_curve_and_the_nodes_go_with_it(space, block, vad):
    model = space(block + RAMP + f"*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,1,{vad},2,0.5\n", end=2.0)
    x, node = (
        probe(model, rigid=7, component="x-displacement"),
        probe(model, node=3, component="x-displacement"),
    )
    force = probe(model, motion=1, component="x-force")
    exact = {0: lambda t: 0.25 * t**2, 1: lambda t: 0.5 * t**3 / 6, 2: lambda t: 0.5 * t}[vad]
    for s in steps(model):
        assert x() == pytest.approx(exact(s.t), abs=1e-12 if vad != 1 else 1e-4)
        assert node() == pytest.approx(x(), abs=1e-13)
        assert force() == pytest.approx({0: 4.0, 1: 4.0 * s.t, 2: 0.0}[vad], abs=1e-9)


def test_damping_stops_a_spin_exponentially(space, constraint, free):
    errors = []
    for step in (0.04, 0.02, 0.01):
        model = space(free(wx=0.5) + "*DAMPING_GLOBAL\n0,2.0\n", end=2.0, step=step)
        damped, begun, off = constraint(model), 0.5 * 1.0 * 0.25, 0.0
        for s in steps(model):
            off = max(off, abs(damped.bodies.spin[0, 0] - 0.5 * math.exp(-2.0 * s.t)))
            assert model.kinetic() + damped.energy["damping"][0] == pytest.approx(begun, rel=4 * step**2)
        errors.append(off)
    np.testing.assert_allclose(np.divide(errors[:-1], errors[1:]), 4.0, rtol=0.1)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,1,0,1\n", r"DOF = 1: CMO of \*MAT_RIGID holds body 7"),
        ("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n9,1,0,1\n", "PID = 9: no rigid body 9; there are: 7"),
        (
            "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,2,0,1\n7,2,2,2\n" + RAMP,
            "another prescribed motion moves body 7",
        ),
        ("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,6,0,1,,,0.5\n", "a driven rotation begins at 0 and lasts"),
        (
            "*BOUNDARY_SPC_NODE\n3,0,1\n",
            r"PID = 7: its node 3 is ruled by supports; a rigid body is held by CMO",
        ),
        (
            "*BOUNDARY_PRESCRIBED_MOTION_NODE\n3,2,0,1\n",
            r"its node 3 is ruled by prescribed motion 1; .* moved by \*BOUNDARY_PRESCRIBED_MOTION_RIGID",
        ),
    ],
)
def test_what_cannot_be_held_or_driven_is_refused(space, held_block, text, message):
    with pytest.raises(DeckError, match=message):
        space(held_block(1, 1) + text)
