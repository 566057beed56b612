"""The step that a contact allows."""

import numpy as np
import pytest

from vmharness.explicit.contact.active_step import active_step
from vmharness.explicit.contact.stable_step import longest_step
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.watch import Watch

DEPTH = 0.01  # to which contacts are pressed


@pytest.mark.parametrize("held", [False, True])
def test_it_is_two_over_the_frequency_of_node_and_corner(scene, bench, held):
    nodes = scene.sheet(bench.flat, [0.0, 1.0], [0.0, 1.0], mass=0.5)
    ball = scene.nodes([0.0, 0.0, 1.0], mass=0.25)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes, penalty=300.0)))
    state = scene.state()
    fixed = np.array([held] * 4 + [False])
    omega = np.sqrt(300.0 * (1.0 / 0.25 + (0.0 if held else 1.0 / 0.5)))
    assert longest_step(contact.passes[0], state.mass, fixed) == pytest.approx(2.0 / omega)


@pytest.mark.parametrize("z", [0.1, 0.5, 1.0])
def test_a_damper_that_lags_shortens_it(scene, bench, z):
    nodes = scene.sheet(bench.flat, [0.0, 1.0], [0.0, 1.0], mass=1e9)
    ball = scene.nodes([0.0, 0.0, 1.0], mass=0.25)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes, penalty=300.0)), vdc=100.0 * z)
    omega = np.sqrt(300.0 / 0.25)
    found = longest_step(contact.passes[0], scene.state().mass, np.zeros(5, bool))
    assert found == pytest.approx(2.0 / omega * (np.sqrt(1.0 + 4.0 * z**2) - 2.0 * z), rel=1e-6)


class Press:
    """Presses nodes against a corner, each with k DEPTH."""

    def __init__(self, corner, balls, force):
        self.corner, self.balls, self.force = corner, balls, force

    def add(self, s):
        s.f[self.corner, 2] += self.force * len(self.balls)
        s.f[self.balls, 2] -= self.force


def pressed(scene, bench, masses, k, vdc, count=1):
    """Nodes at rest, pressed against the corner of a segment: contact, state, what presses, and their rows."""
    m_node, m_corner = masses
    nodes = scene.sheet(bench.flat, [0.0, 1.0], [0.0, 1.0], mass=m_corner)
    balls = scene.nodes([[0.0, 0.0, 0.0]] * count, v=[0.0, 0.0, -DEPTH / 1e-3], mass=m_node)
    contact = bench.contact((bench.tracked(balls), bench.segments(nodes, penalty=k)), vdc=vdc)
    state = scene.state()
    mass = state.mass.copy()
    state.mass[:] = 0.0  # all held
    for _ in bench.march(state, [contact], 1e-3, 1):
        pass
    state.mass[:], state.dt, state.v[:], state.a[:] = mass, 0.0, 0.0, 0.0
    return contact, state, Press(nodes[0, 0], balls, k * DEPTH), balls


def growth(bench, contact, state, press, balls, dt, cycles):
    """How much a small oscillation grows: the largest change of a depth in the last cycles over that in the first."""
    m, corner = state.mass[balls].sum(), press.corner
    start = 1e-3 * DEPTH / dt  # in the relative velocity, without momentum
    state.v[balls, 2] = start * state.mass[corner] / (state.mass[corner] + m)
    state.v[corner, 2] = -start * m / (state.mass[corner] + m)

    together = [corner, *balls]

    def straight(s):
        # The segment tilts a little: its normal would push sideways, and some of the force would go to other corners.
        s.v[:, :2] = 0.0
        s.v[[row for row in range(4) if row != corner]] = 0.0
        s.v[together, 2] -= s.mass[together] @ s.v[together, 2] / s.mass[together].sum()

    depths = [
        np.abs(s.x[press.corner, 2] - s.x[balls, 2] - DEPTH).max()
        for s in bench.march(state, [contact, press], dt, cycles, after=straight)
    ]
    return max(depths[-20:]) / max(depths[:20])


@pytest.mark.parametrize("vdc", [0.0, 20.0, 50.0, 100.0])
@pytest.mark.parametrize(
    ("masses", "k"), [((0.25, 0.5), 300.0), ((1e-3, 2.0), 1e9), ((5.0, 0.01), 1e5), ((1.0, 1.0), 1e2)]
)
def test_below_it_nothing_grows_and_above_it_a_small_oscillation_does(scene, bench, masses, k, vdc):
    made = pressed(scene, bench, masses, k, vdc)
    contact, state = made[0], made[1]
    dt = longest_step(contact.passes[0], state.mass, np.zeros(state.mass.size, bool))
    inverse = np.divide(1.0, state.mass, out=np.zeros_like(state.mass), where=state.mass > 0.0)
    assert active_step([contact], state.mass, inverse).dt == pytest.approx(dt, rel=1e-6)
    kept = state.x.copy()
    assert growth(bench, *made, 0.95 * dt, 2000) <= 1.03
    state.x[:], state.v[:], state.a[:], state.dt = kept, 0.0, 0.0, 0.0
    assert growth(bench, *made, 1.1 * dt, 100) > 3.0


@pytest.mark.parametrize("count", [2, 6])
@pytest.mark.parametrize("vdc", [0.0, 50.0])
def test_contacts_at_one_node_add_up(scene, bench, count, vdc):
    # At a corner that is light beside the nodes: omega^2 = n k / m.
    made = pressed(scene, bench, (1.0, 1e-4), 300.0, vdc, count)
    contact, state = made[0], made[1]
    together = active_step([contact], state.mass, 1.0 / state.mass)
    alone = longest_step(contact.passes[0], state.mass, np.zeros(state.mass.size, bool))
    assert together.row == made[2].corner
    if vdc == 0.0:
        assert together.dt == pytest.approx(alone / np.sqrt(count), rel=1e-3)
    kept = state.x.copy()
    assert growth(bench, *made, 0.95 * together.dt, 2000) <= 1.03
    state.x[:], state.v[:], state.a[:], state.dt = kept, 0.0, 0.0, 0.0
    assert growth(bench, *made, 1.1 * together.dt, 100) > 3.0


def test_contacts_of_the_deck_at_one_node_add_up(scene, bench):
    made = pressed(scene, bench, (1.0, 1e-4), 300.0, 0.0)
    contact, state = made[0], made[1]
    one = active_step([contact], state.mass, 1.0 / state.mass)
    two = active_step([contact, contact], state.mass, 1.0 / state.mass)
    assert two.dt == pytest.approx(one.dt / np.sqrt(2.0))


def test_without_an_active_contact_there_is_no_limit(scene, bench):
    nodes = scene.sheet(bench.flat, [0.0, 1.0], [0.0, 1.0])
    contact = bench.contact((bench.tracked(scene.nodes([0.0, 0.0, 1.0])), bench.segments(nodes)))
    state = scene.state()
    assert active_step([contact], state.mass, 1.0 / state.mass).dt == np.inf


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


# Balls that rest on the corner of a free plate, which rests on the wall; all are pressed by gravity.
STACK = """*SECTION_SHELL
2,2,1.0,2
0.1
*MAT_ELASTIC
2,1e-4,3.0,0.3
*PART
plate
2,2,2
*NODE
11,-0.5,-0.5,0.0
12,0.5,-0.5,0.0
13,0.5,0.5,0.0
14,-0.5,0.5,0.0
*ELEMENT_SHELL
2,2,11,12,13,14
*LOAD_BODY_Z
1,1.0
*SET_NODE_LIST
3
11,12,13,14
"""


def test_what_the_run_says_names_the_node_and_a_step_that_holds(wall_and):
    balls = range(21, 25)
    text = STACK + "*NODE\n" + "".join(f"{n},0.5,0.5,0.0\n" for n in balls)
    text += "*ELEMENT_MASS\n" + "".join(f"{n + 100},{n},1e-3\n" for n in balls)
    text += "*SET_NODE_LIST\n2\n" + ",".join(map(str, balls)) + "\n*CONTROL_CONTACT\n0.3\n\n"
    text += "*CONTACT_NODES_TO_SURFACE\n2,2,4,3\n\n\n*CONTACT_NODES_TO_SURFACE\n3,1,4,3\n\n\n"
    cap = "*CONTROL_TIMESTEP\n,,,,,7\n*DEFINE_CURVE\n7\n0,{0}\n9,{0}\n"

    model = wall_and(text, end=0.2)
    model.caps.clear()  # as if the step were not shortened
    with pytest.raises(SolverError, match="is stiff for the step"):
        list(steps(model))
    fact = next(fact for name, fact in model.facts.items() if name.startswith("Step of contact"))
    assert "node 13 limits it" in fact
    stable = float(fact.split("stable up to ")[1].split(",")[0])

    def wrong(factor, cycles):
        model = wall_and(text + cap.format(factor * stable), end=cycles * stable)
        del model.caps[1:]
        watch = Watch(model)
        try:
            for _ in steps(model, watch):  # the plate tips over, slowly
                pass
        except SolverError as error:
            return str(error)
        return watch.impossible()

    assert wrong(0.95, 2000) == ""
    assert "is stiff for the step" in wrong(1.15, 200)
