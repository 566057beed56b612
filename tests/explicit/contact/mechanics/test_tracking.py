"""Sliding over borders, edges and corners; first contact; letting go."""

import numpy as np
import pytest


def skew(a, b):
    """A plane whose quadrilaterals are irregular."""
    return a + 0.15 * np.sin(5 * b), b + 0.15 * np.sin(4 * a), 0.0


def halves(nodes):
    """Each quadrilateral as two triangles."""
    one, two = nodes[:, [0, 1, 2, 2]], nodes[:, [0, 2, 3, 3]]
    return np.concatenate([one, two])


def dragged(bench, state, contact, row, velocity, dt, steps):
    """Contact force at each step on a node that moves as it is told."""
    found = []
    state.mass[row] = 0.0
    state.v[row] = velocity
    for _ in bench.march(state, [contact], dt, steps):
        found.append(contact.force.copy())
    return np.array(found)


@pytest.mark.parametrize("triangles", [False, True])
@pytest.mark.parametrize("shape", ["flat", "skew"])
@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 4])
def test_force_does_not_jump_where_flat_segments_join(scene, bench, shape, triangles, angle):
    # Along borders, through corners (pi/4 on the regular mesh) and across: f = k d all the way.
    grid = np.linspace(-3, 3, 7)
    nodes = scene.sheet(bench.flat if shape == "flat" else skew, grid, grid, mass=0.0)
    ball = scene.nodes([-2.0, -2.0 + (angle == 0.0) * 2.0, 0.0005], mass=0.0)
    path = 4.0 * np.array([np.cos(angle), np.sin(angle), 0.0])
    contact = bench.contact((bench.tracked(ball), bench.segments(halves(nodes) if triangles else nodes)))
    state = scene.state()
    press = np.array([0.0, 0.0, -0.001 / 1e-3])
    dragged(bench, state, contact, ball[0], press, 1e-3, 1)
    assert contact.force[2] == pytest.approx(0.5)
    state.dt = 0.0
    forces = dragged(bench, state, contact, ball[0], path, 1e-3, 900)
    np.testing.assert_allclose(forces, np.tile([0.0, 0.0, 0.5], (901, 1)), atol=1e-9)


@pytest.mark.parametrize("bend", [0.2, -0.2])
def test_over_bends_the_force_is_the_gradient_of_one_potential(scene, bench, bend):
    # A roof (and a valley) of two slopes: the work of the force along a path below it is the change of k g^2/2.
    nodes = scene.sheet(lambda a, b: (a, b, -bend * abs(a)), [-2.0, 0.0, 2.0], [-2.0, 2.0], mass=0.0)
    ball = scene.nodes([-0.5, 0.1, -0.5 * bend + 0.01], mass=0.0)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes)))
    state = scene.state()
    dragged(bench, state, contact, ball[0], [0.0, 0.0, -60.0], 1e-3, 1)
    state.dt = 0.0
    path = np.array([1.0, 0.3, 0.05 if bend > 0.0 else -0.15])
    forces = dragged(bench, state, contact, ball[0], path, 1e-4, 8000)
    assert forces.any(axis=1).all()
    squares = (forces**2).sum(axis=1) / (2.0 * 1000.0)
    work = -np.cumsum(0.5 * (forces[1:] + forces[:-1]) @ path * 1e-4)
    np.testing.assert_allclose(squares[1:] - squares[0], work, atol=2e-3 * squares.max())


def test_a_node_that_slides_off_an_edge_is_let_go_at_once(scene, bench):
    nodes = scene.sheet(bench.flat, [-1.0, 0.0, 1.0], [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([0.5, 0.0, 0.001], mass=0.0)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes)))
    state = scene.state()
    dragged(bench, state, contact, ball[0], [0.0, 0.0, -2.0], 1e-3, 1)
    state.dt = 0.0
    forces = dragged(bench, state, contact, ball[0], [1.0, 0.0, 0.0], 1e-3, 600)
    x = 0.5 + 1e-3 * np.arange(601)
    held = x <= 1.0 + 0.025 / 2  # MAXPAR in xi of a segment of length 1
    np.testing.assert_allclose(forces[held, 2], 1.0, rtol=1e-9)
    assert not forces[~held].any()
    assert contact.nodes_in_contact() == 0


def test_the_edge_of_a_shell_with_thickness_is_round(scene, bench):
    # The node circles about the edge at 0.9 of the reach: the same force all the way from above to below.
    nodes = scene.sheet(bench.flat, [-1.0, 0.0, 1.0], [-1.0, 1.0], mass=0.0)
    reach, radius = 0.1, 0.09
    ball = scene.nodes([1.0, 0.2, radius], mass=0.0)
    sides = (bench.tracked(ball, thickness=0.08), bench.segments(nodes, thickness=0.12, two_sided=True))
    contact = bench.contact(sides)
    state, turn = scene.state(), np.linspace(0.0, np.pi, 400)
    path = np.column_stack([1.0 + radius * np.sin(turn), 0 * turn + 0.2, radius * np.cos(turn)])
    state.v[ball[0]] = (path[1] - path[0]) / 1e-3

    def follow(s):
        s.v[ball[0]] = (path[min(s.cycle + 1, 399)] - path[s.cycle]) / 1e-3

    for s in bench.march(state, [contact], 1e-3, 398, after=follow):
        outward = (path[s.cycle] - [1.0, 0.2, 0.0]) / radius
        np.testing.assert_allclose(contact.force, 1000.0 * (reach - radius) * outward, atol=1e-8)


@pytest.mark.parametrize("two_sided", [False, True])
@pytest.mark.parametrize("speed", [3.0, 300.0, 30000.0])
def test_a_node_that_crosses_within_one_step_is_caught(scene, bench, speed, two_sided):
    # At 30000 it goes through sixty times the length of a segment, and many thicknesses, in one step.
    nodes = scene.sheet(skew, np.linspace(-3, 3, 13), np.linspace(-3, 3, 13), mass=0.0)
    ball = scene.nodes([0.3, 0.2, speed * 5e-4], v=[0.02 * speed, 0.0, -speed])
    kind = bench.segments(nodes, penalty=1e9, thickness=0.002 * two_sided, two_sided=two_sided)
    contact = bench.contact((bench.tracked(ball), kind))
    state = scene.state()
    for _ in bench.march(state, [contact], 1e-3, 1):
        pass
    assert contact.nodes_in_contact() == 1
    assert contact.force[2] > 0.0


def test_a_node_that_was_behind_stays_free(scene, bench):
    nodes = scene.sheet(bench.flat, np.linspace(-1, 1, 5), np.linspace(-1, 1, 5), mass=0.0)
    ball = scene.nodes([1.5, 0.1, -0.001], v=[-2.0, 0.0, 0.0])
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes)))
    for _ in bench.march(scene.state(), [contact], 1e-3, 1000):
        assert contact.nodes_in_contact() == 0


@pytest.mark.parametrize("two_sided", [False, True])
def test_nothing_slips_through_a_crumpled_surface(scene, bench, two_sided):
    # A rain of nodes, slow and fast, on hills with folds up to 70 degrees; none ends below.
    def hills(a, b):
        return a, b, 0.25 * np.cos(7.0 * a) * np.cos(6.0 * b) + 0.2 * np.sin(13.0 * a + 2.0 * b)

    rng = np.random.default_rng(5)
    grid = np.linspace(-2, 2, 21)
    nodes = scene.sheet(hills, grid, grid, mass=0.0)
    start = np.column_stack([rng.uniform(-1.2, 1.2, (400, 2)), rng.uniform(0.6, 1.0, 400)])
    motion = np.column_stack([rng.uniform(-1, 1, (400, 2)), -(10.0 ** rng.uniform(0.7, 1.5, 400))])
    drops = scene.nodes(start, v=motion, mass=1e-3)
    kind = bench.segments(nodes, penalty=4000.0, thickness=0.06 * two_sided, two_sided=two_sided)
    contact = bench.contact((bench.tracked(drops), kind))
    state = scene.state()
    touched = np.zeros(400, bool)
    for _ in bench.march(state, [contact], 2e-4, 1500):
        touched |= contact.forces.any(axis=1)
    within = np.abs(state.x[drops, :2]).max(axis=1) < 1.9
    assert touched[within].all()
    above = state.x[drops, 2] - hills(state.x[drops, 0], state.x[drops, 1])[2]
    assert (above[within] > -0.15).all()


def test_a_corner_of_three_walls_holds_what_runs_into_it(scene, bench):
    # The inner corner of a box: all three walls push the node back at once, and it leaves as it came.
    grid = np.linspace(0.0, 2.0, 5)
    floor = scene.sheet(lambda a, b: (a, b, 0.0), grid, grid, mass=0.0)
    left = scene.sheet(lambda a, b: (0.0, a, b), grid, grid, mass=0.0)
    back = scene.sheet(lambda a, b: (b, 0.0, a), grid, grid, mass=0.0)
    walls = np.concatenate([floor, left, back])
    points = scene.state().x
    _, merged = np.unique(np.round(points, 9), axis=0, return_index=True)
    same = {tuple(np.round(points[r], 9)): r for r in merged}
    walls = np.array([[same[tuple(np.round(points[r], 9))] for r in face] for face in walls])
    ball = scene.nodes([0.1, 0.11, 0.12], v=[-1.0, -1.1, -1.2], mass=0.01)
    contact = bench.contact((bench.tracked(ball), bench.segments(walls)))
    held = False
    for s in bench.march(scene.state(), [contact], 1e-5, 30000):
        depth = np.maximum(-s.x[ball[0]], 0.0)
        np.testing.assert_allclose(contact.force, 1000.0 * depth, rtol=1e-9, atol=1e-9)
        held |= bool((depth > 0.0).all())
    assert held
    assert contact.nodes_in_contact() == 0
    np.testing.assert_allclose(s.v[ball[0]], [1.0, 1.1, 1.2], rtol=1e-4)


def test_release_depth_lets_go(scene, bench):
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([0.0, 0.0, 0.0], v=[0.0, 0.0, -1.0], mass=0.0)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes, release=0.05)))
    for s in bench.march(scene.state(), [contact], 1e-3, 100):
        if s.cycle != 50:
            assert contact.force[2] == pytest.approx(-1000.0 * s.x[ball[0], 2] if s.cycle < 50 else 0.0)


def test_birth_and_death(scene, bench):
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
    early = scene.nodes([0.0, 0.0, 0.0105], v=[0.0, 0.0, -1.0], mass=0.0)
    late = scene.nodes([0.1, 0.0, 0.0305], v=[0.0, 0.0, -1.0], mass=0.0)
    contact = bench.contact((bench.tracked([early[0], late[0]]), bench.segments(nodes)), bt=0.02, dt=0.05)
    for s in bench.march(scene.state(), [contact], 1e-3, 60):
        touching = 31 <= s.cycle < 50  # the early one crosses before birth
        assert contact.forces.any(axis=1).tolist() == [False, touching]


def leading_edge(scene, speed):
    """The bottom (z = 0, x < 0) and the leading face (x = 0, z > 0) of a body that moves along x; one is joined to one."""
    low = scene.sheet(
        lambda a, b: (b, a, 0.0), [-2.0, -1.0, 0.0, 1.0, 2.0], [-2.0, -1.0, 0.0], mass=0.0, v=speed
    )
    edge = np.unique(low)[-5:]
    high = scene.sheet(lambda a, b: (0.0, a, b), [-2.0, -1.0, 0.0, 1.0, 2.0], [1.0, 2.0], mass=0.0, v=speed)
    first = np.stack([edge[:-1], edge[1:], np.unique(high)[1:5], np.unique(high)[:4]], axis=1)
    return low, np.concatenate([first, high])


@pytest.mark.parametrize("surface", [True, False])
@pytest.mark.parametrize("y", [0.3, 0.0])
@pytest.mark.parametrize("per_step", [0.002, 0.3])
def test_a_swept_node_goes_to_the_nearest_face(scene, bench, per_step, y, surface):
    # 0.01 behind the bottom: the leading face pushes it as far, and then only the bottom does. Without a surface of its
    # own it is pushed up to MAXPAR of the segment's size, the root of twice its area.
    depth, dt = 0.01, 1e-3
    far = depth if surface else 0.0125 * np.sqrt(2.0)
    low, high = leading_edge(scene, [per_step / dt, 0.0, 0.0])
    patch = scene.sheet(lambda a, b: (1.0 + a, y + b, depth), [-0.5, 0.0, 0.5], [-0.5, 0.0, 0.5], mass=0.0)
    node = patch[0, 2]
    sides = bench.tracked(node, faces=patch if surface else None), bench.segments(np.concatenate([low, high]))
    contact, state = bench.contact(sides), scene.state()
    work, met = 0.0, False
    for s in bench.march(state, [contact], dt, int(2.0 / per_step)):
        into = s.x[low[-1, -1], 0] - 1.0
        if 1e-9 < into < 1.9:
            expected = [0.0, 0.0, -depth] if into > far else [into, 0.0, 0.0]
            np.testing.assert_allclose(contact.force, 1000.0 * np.array(expected), atol=1e-9)
            met = True
        work += contact.force[0] * per_step
    assert met
    assert work <= 1.2 * 500.0 * far**2


def test_a_node_whose_surface_does_not_face_the_side_stays_on_top(scene, bench):
    # As the corner of a block that stands flush on another: pressed deeper than it is far from the edge.
    low, high = leading_edge(scene, [0.0, 0.0, 0.0])
    node = scene.nodes([-0.001, 0.1, -0.001], v=[0.0, 0.0, 10.0], mass=0.0)[0]
    top = scene.sheet(lambda a, b: (-0.001 - a, 0.1 + b, -0.001), [0.0, 0.5], [0.0, 0.5], mass=0.0)
    side = scene.sheet(lambda a, b: (-0.001, 0.1 + a, -0.001 - b), [0.0, 0.5], [0.0, 0.5], mass=0.0)
    own = np.concatenate([top[:, ::-1], side[:, ::-1]])
    own[own == top[0, 0]] = own[own == side[0, 0]] = node
    sides = bench.tracked(node, faces=own), bench.segments(np.concatenate([low, high]))
    contact, state = bench.contact(sides), scene.state()
    for s in bench.march(state, [contact], 1e-4, 100):
        np.testing.assert_allclose(contact.force, [0.0, 0.0, -1000.0 * max(s.x[node, 2], 0.0)], atol=1e-9)


def test_after_four_borders_the_gap_is_that_of_the_segment_that_is_reached(scene, bench):
    strip = scene.sheet(bench.flat, np.arange(31.0), [-5.0, 5.0], mass=0.0)
    ball = scene.nodes([0.5, 0.0, 0.03], v=[4000.0, 0.0, 0.0], mass=0.0)
    sides = bench.tracked(ball), bench.segments(strip, thickness=0.1, two_sided=True)
    contact = bench.contact(sides)
    for _ in bench.march(scene.state(), [contact], 1e-3, 2):
        np.testing.assert_allclose(contact.force, [0.0, 0.0, 1000.0 * (0.05 - 0.03)], atol=1e-9)
