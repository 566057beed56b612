"""Limits of a contact: each is counted where it is reached, and said of no other contact."""

from types import SimpleNamespace

import numpy as np
import pytest

from vmharness.explicit.contact.limits import limits_reached


def facts(contact):
    """What is said of a contact whose nodes have the numbers 100, 101, ..."""
    return limits_reached(SimpleNamespace(forces=[contact], ids=100 + np.arange(1000)))


def stack(scene, bench, sheets, balls=1, **options):
    """Separate sheets one below the other, and nodes that pass through all of them within one step of 1e-3."""
    levels = [
        scene.sheet(lambda a, b, z=z: (a, b, z), [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
        for z in -0.01 * np.arange(sheets)
    ]
    nodes = scene.nodes([[0.1 * i, 0.0, 0.05] for i in range(balls)], v=[0.0, 0.0, -200.0], mass=0.0)
    sides = (bench.tracked(nodes), bench.segments(np.concatenate(levels), **options))
    return bench.contact(sides), 100 + nodes


@pytest.mark.parametrize("sheets", [6, 7, 9])
def test_a_node_in_more_than_six_contacts_is_reported(scene, bench, sheets):
    contact, (ball,) = stack(scene, bench, sheets)
    for _ in bench.march(scene.state(), [contact], 1e-3, 1):
        pass
    assert contact.passes[0].nodes["count"] == 6
    assert facts(contact) == (
        {}
        if sheets == 6
        else {"Contact limit reached in contact 1": f"node {ball} had more than 6 contacts in 1 cycle"}
    )


def test_the_node_that_needs_more_contacts_for_longest_is_named(scene, bench):
    # Within the thickness of two-sided shells, a contact that is refused is asked for again in each cycle.
    contact, balls = stack(scene, bench, 8, balls=3, thickness=1.0, two_sided=True)
    state = scene.state()
    state.v[balls[0] - 100] = [0.0, 0.0, 0.0]
    state.v[balls[1:] - 100] = [0.0, 0.0, -10.0]
    state.v[balls[2] - 100] = [0.0, 0.0, -1.0]

    def leave(s):
        if s.cycle == 4:
            state.v[balls[1:] - 100] = [0.0, 0.0, 2e3]

    for _ in bench.march(state, [contact], 1e-3, 8, after=leave):
        pass
    name, fact = facts(contact).popitem()
    assert name == "Contact limit reached in contact 1"
    assert fact == f"node {balls[0]} had more than 6 contacts in 9 cycles; so had 2 other nodes"


@pytest.mark.parametrize(("borders", "times"), [(3, 0), (4, 1), (7, 1)])
def test_a_node_that_crosses_four_borders_in_one_step_is_reported(scene, bench, borders, times):
    # It touches the strip at the first step, slides over segments of length 1 in the second, and then rests.
    strip = scene.sheet(bench.flat, np.arange(31.0), [-5.0, 5.0], mass=0.0)
    ball = scene.nodes([0.5, 0.0, 0.001], v=[0.0, 0.0, -2.0], mass=0.0)
    contact = bench.contact((bench.tracked(ball), bench.segments(strip)))
    state = scene.state()

    def slide(s):
        if s.cycle > 0:
            state.v[ball] = [borders / 1e-3 if s.cycle == 1 else 0.0, 0.0, 0.0]

    for _ in bench.march(state, [contact], 1e-3, 4, after=slide):
        pass
    fact = "4 segment borders were crossed in one step 1 time; such a contact can end too early"
    assert facts(contact) == ({"Border limit reached in contact 1": fact} if times else {})
    assert contact.passes[0].states["segment"][0, 0] == min(borders, 4)
    assert contact.nodes_in_contact() == (1 if borders <= 4 else 0)
