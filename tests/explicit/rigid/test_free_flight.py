"""Rigid bodies in free flight, against what is exact: forces, torques, and turning without any."""

import numpy as np
import pytest

from vmharness.explicit import energy
from vmharness.explicit.loop import steps

MASS, CENTRE, MOMENTS = 8.0, (1.0, 0.5, 0.25), (2.5, 8.5, 10.0)  # of the block


def test_mass_centre_and_inertia_are_sums_over_the_corners(space, bodies, block):
    model = space(block)
    b, c = bodies(model), model.centre(7)
    assert model.state.mass[c] == pytest.approx(MASS, rel=1e-14)
    np.testing.assert_allclose(model.state.x[c], CENTRE, rtol=1e-14)
    np.testing.assert_allclose(sorted(b.principal[0]), sorted(MOMENTS), rtol=1e-14)
    assert not model.state.mass[: model.node_count].any()
    np.testing.assert_allclose(model.state.lumped[: model.node_count], 1.0, rtol=1e-14)


def test_a_constant_force_at_the_centre_is_exact(space, bodies, block):
    model = space(block + "*LOAD_RIGID_BODY\n7,1,1,16.0\n", end=2.0)
    for s in steps(model):
        place = s.x[:8].mean(axis=0)
        np.testing.assert_allclose(place, np.add(CENTRE, (s.t**2, 0.0, 0.0)), rtol=0, atol=1e-13)
        np.testing.assert_allclose(s.v[:8, 0] + 0.5 * s.dt * s.a[:8, 0], 2.0 * s.t, atol=1e-12)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_constant_torque_about_a_principal_axis_is_exact(space, bodies, block, axis):
    model = space(block + f"*LOAD_RIGID_BODY\n7,{axis + 5},1,4.0\n", end=3.0)
    rate, b = 4.0 / MOMENTS[axis], bodies(model)
    arm = model.x0[:8] - np.array(CENTRE)
    for s in steps(model):
        angle = rate * s.t**2 / 2
        np.testing.assert_allclose(b.angle[0], np.eye(3)[axis] * angle, atol=1e-12)
        np.testing.assert_allclose(b.spin[0], np.eye(3)[axis] * rate * s.t, atol=1e-12)
        along, u = np.eye(3)[axis], np.cross(np.eye(3)[axis], arm)
        turned = arm * np.cos(angle) + u * np.sin(angle) + np.outer(arm @ along, along) * (1 - np.cos(angle))
        np.testing.assert_allclose(s.x[:8], turned + np.array(CENTRE), atol=1e-12)
        assert energy.kinetic(s) == pytest.approx(0.0, abs=1e-20)
        assert model.kinetic() == pytest.approx(0.5 * MOMENTS[axis] * (rate * s.t) ** 2, rel=1e-11, abs=1e-20)


def test_work_of_force_and_torque_is_the_kinetic_energy(space, bodies, block):
    loads = "*LOAD_RIGID_BODY\n7,2,1,3.0\n7,6,1,4.0\n*LOAD_NODE_POINT\n3,3,1,0.5\n"
    model = space(block + loads, end=3.0, step=2e-3)
    for _ in steps(model):
        work = sum(
            account[0] for account in energy.accounts([*model.forces, *model.constraints], "external work")
        )
        assert model.kinetic() == pytest.approx(work, rel=2e-5, abs=1e-9)


TUMBLING = dict(ixx=1.0, iyy=2.0, izz=3.0, wx=0.3, wy=1.0, wz=0.5)


def tumble(space, bodies, free, per_turn, turns):
    """Largest relative errors of energy and of angular momentum of the intermediate-axis tumble, and the last place."""
    size = np.linalg.norm([TUMBLING[w] for w in ("wx", "wy", "wz")])
    turn = 2 * np.pi / size
    model = space(free(**TUMBLING), end=0.9999999 * turns * turn, step=turn / per_turn)
    b, first, off, drift = bodies(model), None, 0.0, 0.0
    for _ in steps(model):
        first = first or (model.kinetic(), b.L[0].copy())
        off = max(off, abs(model.kinetic() / first[0] - 1.0))
        drift = max(drift, np.abs(b.L[0] - first[1]).max() / np.linalg.norm(first[1]))
    return off, drift, model.state.x[0].copy(), model.state.t


@pytest.mark.parametrize("turns", [50])
def test_a_torque_free_body_keeps_energy_and_momentum_over_fifty_turns(space, bodies, free, turns):
    off, drift, x, _ = tumble(space, bodies, free, 5000, turns)
    assert off < 1e-6
    assert drift < 1e-15
    assert np.linalg.norm(x) == pytest.approx(1.0, rel=1e-13)


def test_the_error_of_energy_falls_fourfold_at_half_the_step(space, bodies, free):
    errors = [tumble(space, bodies, free, per_turn, 5)[0] for per_turn in (100, 200, 400)]
    np.testing.assert_allclose(np.divide(errors[:-1], errors[1:]), 4.0, rtol=0.03)


def test_order_of_the_orientation_is_two(space, bodies, free):
    *_, exact, end = tumble(space, bodies, free, 12800, 3)
    errors = []
    for per_turn in (100, 200, 400):
        *_, x, t = tumble(space, bodies, free, per_turn, 3)
        assert t == pytest.approx(end, rel=1e-12)
        errors.append(np.linalg.norm(x - exact))
    np.testing.assert_allclose(np.divide(errors[:-1], errors[1:]), 4.0, rtol=0.03)


def test_a_symmetric_top_precesses_as_euler_says(space, bodies, free):
    # I = (1, 1, 2), omega = (0.2, 0, 1): the axis goes round L at |L|/I1 = sqrt(0.2^2 + 2^2).
    top = free(ixx=1.0, iyy=1.0, izz=2.0, wx=0.2, wy=0.0, wz=1.0, x=0.0, y=0.0, z=1.0)
    rate, turns = np.hypot(0.2, 2.0), 3
    model = space(top, end=turns * 2 * np.pi / rate, step=2 * np.pi / rate / 2000)
    L = bodies(model).L[0].copy()
    for s in steps(model):
        assert s.x[0] @ L / np.linalg.norm(L) == pytest.approx(2.0 / rate, abs=1e-12)
    np.testing.assert_allclose(s.x[0], [0.0, 0.0, 1.0], atol=1e-5)
