"""The step that a contact allows."""

import numpy as np
import pytest

from vmharness.explicit.contact.stable_step import longest_step


@pytest.mark.parametrize("held", [False, True])
def test_it_is_two_over_the_frequency_of_node_and_corner(scene, bench, held):
    nodes = scene.sheet(bench.flat, [0.0, 1.0], [0.0, 1.0], mass=0.5)
    ball = scene.nodes([0.0, 0.0, 1.0], mass=0.25)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes, penalty=300.0)))
    state = scene.state()
    fixed = np.array([held] * 4 + [False])
    omega = np.sqrt(300.0 * (1.0 / 0.25 + (0.0 if held else 1.0 / 0.5)))
    assert longest_step(contact.passes[0], state.mass, fixed) == pytest.approx(2.0 / omega)


@pytest.mark.parametrize(("factor", "grows"), [(0.98, False), (1.02, True)])
def test_beyond_it_a_small_oscillation_grows(scene, bench, factor, grows):
    # A node is pressed into the corner of a free segment to a depth of 0.01, then moved by a hundredth of that.
    nodes = scene.sheet(bench.flat, [0.0, 1.0], [0.0, 1.0], mass=0.5)
    ball = scene.nodes([0.0, 0.0, 0.0], v=[0.0, 0.0, -10.0], mass=0.25)[0]
    contact = bench.contact((bench.tracked([ball]), bench.segments(nodes, penalty=300.0)))
    state = scene.state()
    dt, mass = factor * longest_step(contact.passes[0], state.mass, np.zeros(5, bool)), state.mass.copy()
    state.mass[:] = 0.0  # all held
    for _ in bench.march(state, [contact], 1e-3, 1):
        pass
    state.mass[:], state.dt, state.v[:] = mass, 0.0, 0.0
    state.v[ball, 2] = 1e-4 / dt

    class Press:
        def add(self, s):
            s.f[[nodes[0, 0], ball], 2] += [3.0, -3.0]

    depths = [s.x[0, 2] - s.x[ball, 2] for s in bench.march(state, [contact, Press()], dt, 10)]
    assert (max(abs(depth - 0.01) for depth in depths) > 1.5e-3) == grows


def test_a_contact_that_is_too_stiff_is_told(wall_and):
    ball = "*NODE\n5,0,0,0.001\n*ELEMENT_MASS\n105,5,1e-9\n*SET_NODE_LIST\n2\n5\n"
    control = "*CONTROL_CONTACT\n{}\n\n*CONTACT_NODES_TO_SURFACE\n2,1,4,3\n\n\n"
    stiff, soft = wall_and(ball + control.format(1.0)), wall_and(ball + control.format(1e-9))
    assert "should not exceed" in stiff.facts["Step of contact 1"]
    assert soft.facts == {}
    short = wall_and(
        ball + control.format(1.0) + "*CONTROL_TIMESTEP\n,,,,,7\n*DEFINE_CURVE\n7\n0,1e-7\n1,1e-7\n"
    )
    assert short.facts == {}
