"""The time loop against exact solutions of the difference equations and of the differential ones."""

import math
from pathlib import Path

import numpy as np
import pytest

from vmharness.backends.builtin.cycles import run
from vmharness.backends.protocol import Job
from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps

BALL = "*NODE\n5,0.0,0.0,{z}\n*ELEMENT_MASS\n9,5,{mass}\n"
CONTACT = """*SET_NODE_LIST
2
5
*CONTROL_CONTACT
{slsfac}

*CONTACT_NODES_TO_SURFACE
2,1,4,3


"""


def motion(model, row=4, axis=2):
    """t, x, v_n, kinetic energy at every cycle."""
    out = [
        (s.t, s.x[row, axis], s.v[row, axis] + 0.5 * s.dt * s.a[row, axis], energy.kinetic(s))
        for s in steps(model)
    ]
    return np.array(out).T


def test_projectile_is_exact_at_every_step(wall_and):
    ball = BALL.format(z=100.0, mass=2.0) + "*LOAD_BODY_Z\n1,9.81\n*INITIAL_VELOCITY_NODE\n5,3.0,0.0,7.0\n"
    model = wall_and(ball, end=2.0)
    t, z, v, kinetic = motion(model)
    assert t[-1] >= 2.0
    np.testing.assert_allclose(z, 100.0 + 7.0 * t - 9.81 * t**2 / 2, rtol=1e-12)
    np.testing.assert_allclose(v, 7.0 - 9.81 * t, atol=1e-11)
    np.testing.assert_allclose(kinetic, 0.5 * 2.0 * (9.0 + v**2), rtol=1e-12)
    assert model.state.x[4, 0] == pytest.approx(3.0 * t[-1], rel=1e-12)


def test_positive_body_load_pulls_to_the_negative_axis(wall_and):
    for axis, name in enumerate("XYZ"):
        model = wall_and(BALL.format(z=5.0, mass=1.0) + f"*LOAD_BODY_{name}\n1,9.81\n", end=0.1)
        next(steps(model))
        assert model.state.a[4, axis] == -9.81
        assert np.count_nonzero(model.state.a[4]) == 1


def oscillator(wall_and, density):
    """A mass that meets the wall at t = 0: half a sine of frequency sqrt(k/m) until it leaves."""
    mass, slsfac = 0.5, 1.0
    model = wall_and(
        BALL.format(z=0.0, mass=mass) + CONTACT.format(slsfac=slsfac) + "*INITIAL_VELOCITY_NODE\n5,,,-0.01\n",
        end=1.0,
        density=density,
    )
    return model, math.sqrt(math.sqrt(2.0) * slsfac / mass)


def test_oscillator_has_the_frequency_of_central_differences(wall_and):
    model, omega = oscillator(wall_and, density=1e-2)
    t, z, *_ = motion(model)
    dt = t[1]
    numeric = 2.0 / dt * math.asin(omega * dt / 2.0)
    amplitude = 0.01 * dt / math.sin(numeric * dt)  # z_1 = -v_0 dt
    assert omega * dt > 0.05
    np.testing.assert_allclose(z, -amplitude * np.sin(numeric * t), atol=1e-14)


def test_order_of_accuracy_is_two(wall_and):
    errors = []
    for density in (4e-2, 1e-2, 2.5e-3):  # the step goes with the root of the density
        model, omega = oscillator(wall_and, density)
        t, z, *_ = motion(model)
        errors.append(np.abs(z + 0.01 / omega * np.sin(omega * t)).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2.0, atol=0.1)


def test_energy_of_an_oscillator_balances_to_second_order(wall_and):
    # Total energy differs from the initial one by m dt^2/8 (a_n^2 - a_0^2), no more.
    model, omega = oscillator(wall_and, density=1e-2)
    contact = model.forces[1].energy["contact"]
    totals = np.array([energy.kinetic(s) + contact[0] for s in steps(model)])
    dt = model.state.dt
    bound = 0.5 * dt**2 / 8.0 * (0.01 * omega) ** 2
    assert np.abs(totals / totals[0] - 1.0).max() <= 1.01 * bound / totals[0]


def test_ratio_is_one_while_nothing_has_been_put_in():
    assert energy.ratio(total=0.0, initial=0.0, external_work=0.0) == 1.0
    assert energy.ratio(total=3.0, initial=1.0, external_work=3.0) == 0.75


def test_end_cycle_ends_the_run(wall_and, deck):
    model = wall_and("", end="1.0,7")
    assert sum(1 for _ in steps(model)) == 8
    assert model.state.cycle == 7


def test_divergence_is_an_error_with_time_cycle_and_node(wall_and):
    free = "*NODE\n11,5,5,0\n12,6,5,0\n13,6,6,0\n14,5,6,0\n*ELEMENT_SHELL\n2,1,11,12,13,14\n"
    model = wall_and(free + "*CONTROL_TIMESTEP\n0.0,3.0\n*INITIAL_VELOCITY_NODE\n11,1e-6\n", end=1e6)
    times = []
    with pytest.raises(SolverError, match=r"t = .*, cycle \d+: .*diverged, first seen at node 1[1-4]"):
        times.extend(s.t for s in steps(model))
    assert len(times) > 10


def free_square(wall_and, tssfac, end):
    """A lone free square shell that is pulled at one corner."""
    free = "*NODE\n11,5,5,0\n12,7,5,0\n13,7,7,0\n14,5,7,0\n*ELEMENT_SHELL\n2,2,11,12,13,14\n"
    part = "*PART\nfree\n2,1,2\n*MAT_ELASTIC\n2,1e-4,3.0,0.3\n"
    start = f"*CONTROL_TIMESTEP\n0.0,{tssfac}\n*INITIAL_VELOCITY_NODE\n13,1.0,1.0,0.0\n"
    return wall_and(part + free + start, end=end)


def test_a_run_that_makes_energy_from_nothing_is_an_error_before_it_overflows(wall_and):
    # Stable only to 0.877 L/c = L/(c sqrt(1 + nu)). TSSFAC > 1 is of that, and asks for more than is stable.
    # A blown-up shell has a long step, which leaps past the end: that is no way to finish.
    for end in (0.3, 1.0, 100.0):
        with pytest.raises(SolverError, match=r"cycle \d+: .*diverged.* first seen at node 1[1-4]"):
            list(steps(free_square(wall_and, 1.02, end)))
    for stable in (0.9, 0.8):
        *_, last = steps(free_square(wall_and, stable, end=100.0))
        assert last.t >= 100.0


def test_a_contact_too_stiff_for_the_step_is_an_error(wall_and):
    model, _ = oscillator(wall_and, density=1e-2)
    model.forces[1].passes[0].segments["penalty"] *= 1e9
    with pytest.raises(SolverError, match="the run has diverged: its energy is"):
        list(steps(model))


def test_a_step_that_leads_nowhere_is_an_error(wall_and):
    with pytest.raises(SolverError, match="the time step has vanished"):
        list(steps(wall_and("", density=1e-40)))


def test_step_below_dtmin_is_an_error(wall_and):
    # A free shell squashed in its plane: its characteristic length shrinks.
    free = "*NODE\n11,5,5,0\n12,6,5,0\n13,6,6,0\n14,5,6,0\n*ELEMENT_SHELL\n2,1,11,12,13,14\n"
    squash = "*INITIAL_VELOCITY_NODE\n12,-20.0\n13,-20.0\n"
    model = wall_and(free + squash, end="10.0,0,0.9")
    with pytest.raises(SolverError, match=r"time step has vanished: .* set by shells of part 1"):
        list(steps(model))


def test_nothing_that_sets_a_step_is_an_error(deck):
    from vmharness.explicit.build import build

    model = build(deck("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n1,0,0,0\n*ELEMENT_MASS\n1,1,1.0\n"))
    with pytest.raises(SolverError, match=r"nothing sets it; .*LCTM can"):
        list(steps(model))


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        (
            "*DATABASE_HISTORY_NODE\n1,2\n3,99\n",
            r"deck\.k:25: \*DATABASE_HISTORY_NODE: IDS = 99: no \*NODE 99",
        ),
        ("*DATABASE_HISTORY_NODE_ID\n99,tip\n", r"ID1 = 99: no \*NODE 99"),
    ],
)
def test_a_history_of_a_node_that_is_not_there_is_an_error(wall_and, asked, message):
    with pytest.raises(DeckError, match=message):
        wall_and(asked)
    wall_and(asked.replace("99", "4"))


def test_a_step_that_does_not_change_the_time_is_an_error(wall_and):
    """Shorter and shorter steps, down to 5e-17, half of the last digit of the time."""
    curve = "*DEFINE_CURVE\n2\n0.0,1e-3\n0.59,1e-3\n0.599996,5e-17\n10.0,5e-17\n*CONTROL_TIMESTEP\n,,,,,2\n"
    with pytest.raises(SolverError, match="the step 5e-17 is below the round-off of the time"):
        list(steps(wall_and(curve, end=0.6)))


def test_a_run_that_ends_in_cycle_0_has_a_message_and_no_history(deck):
    text = "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n1,0.0,0.0,0.0\n*ELEMENT_MASS\n1,1,1e-300\n"
    pull = (
        "*DEFINE_CURVE\n1\n0.0,1.0\n10.0,1.0\n*LOAD_NODE_POINT\n1,3,1,1e10\n*CONTROL_TIMESTEP\n,,,,,1\n*END\n"
    )
    output = run(Job(deck(text + pull), {}, Path()))
    assert output.history is None
    assert "cycle 0: the motion is no longer finite" in output.failure
    assert "LCTM" not in output.failure
