"""Contacts that are tracked several at a time are where each of them alone is found."""

import numpy as np
import pytest

from vmharness.explicit.contact.geometry import interpolate, normal, shape
from vmharness.explicit.contact.neighbours import find_neighbours
from vmharness.explicit.contact.records import (
    CONTACT_STATE,
    MAX_CONTACTS,
    Segments,
    Tracked,
    node_records,
    segment_records,
)
from vmharness.explicit.contact.tracking import HELD, track
from vmharness.explicit.contact.tracking_simd import buffers, track_settled
from vmharness.explicit.kernels.simd import LANES

OWN = np.zeros((0, 4), np.intp)  # the nodes have no faces of their own
POINTS = 3 * LANES + 5  # so that the last lanes are not full


def over(corners, s, xi, eta, height):
    """The point at a height over xi, eta of segment s; odd ones are triangles."""
    triangle, c = bool(s % 2), tuple(map(tuple, corners))
    return np.array(interpolate(c, shape(triangle, xi, eta))) + height * np.array(
        normal(triangle, c, xi, eta)
    )


@pytest.fixture
def sliding():
    """Nodes a little below warped quadrilaterals and triangles that have moved, most of them well within, some not."""
    rng = np.random.default_rng(3)
    flat = np.array([[0.0, 0.0], [2.0, 0.1], [2.2, 1.8], [-0.1, 2.0]])
    x, nodes = [], []
    for s in range(6):
        corners = np.column_stack([flat + np.array([4.0 * s, 0.0]), rng.uniform(-0.03, 0.03, 4)])
        nodes.append([4 * s, 4 * s + 1, 4 * s + 2, 4 * s + (2 if s % 2 else 3)])
        x.extend(corners)
    segment = rng.integers(0, 6, POINTS)
    place = np.where(segment[:, None] % 2, 1.0 / 3.0, 0.0) + rng.uniform(-0.15, 0.15, (POINTS, 2))
    height = rng.uniform(-0.25, -0.12, POINTS)
    below = np.array([over(np.array(x)[nodes[s]], s, *place[t], height[t]) for t, s in enumerate(segment)])
    below[::11, 0] += 1.5  # gone
    x = np.array([*x, *below])
    nodes = np.array(nodes)
    held = Segments(
        nodes=nodes,
        penalty=np.ones(6),
        thickness=np.zeros(6),
        release=np.full(6, 0.22),
        two_sided=np.zeros(6, bool),
    )
    tracked = Tracked(len(x) - POINTS + np.arange(POINTS), np.ones(POINTS), np.zeros(POINTS), np.ones(POINTS))
    states = np.zeros((MAX_CONTACTS, POINTS), CONTACT_STATE)
    states[0]["segment"], states[0]["side"] = segment, 1.0
    states[0]["xi"], states[0]["eta"] = (place + rng.uniform(-0.05, 0.05, place.shape)).T
    records = node_records(tracked)
    records["count"] = 1
    records["count"][4] = 0
    return x, records, segment_records(held), states, find_neighbours(nodes)


def test_lanes_find_what_each_contact_alone_finds(sliding):
    x, nodes, segments, states, (first, neighbours) = sliding
    together, before = states.copy(), states.copy()
    track_settled(segments, x, nodes, together, *buffers())
    settled = nodes["settled"] & (nodes["count"] > 0)
    assert 0.4 * POINTS < settled.sum() < 0.9 * POINTS
    for t in range(POINTS):
        if not settled[t]:
            assert together[:, t].tobytes() == before[:, t].tobytes()
            continue
        assert track(segments, first, neighbours, OWN, 1.025, x, 0.0, nodes[t], states[:, t], 0) == HELD
        for name in ("segment", "side", "xi", "eta", "normal", "gap"):
            np.testing.assert_allclose(together[0, t][name], states[0, t][name], rtol=1e-12, atol=1e-12)


def test_nodes_that_go_deeper_than_allowed_or_beyond_the_border_are_left(sliding):
    x, nodes, segments, states, (first, neighbours) = sliding
    track_settled(segments, x, nodes, states, *buffers())
    held = np.array(
        [
            track(segments, first, neighbours, OWN, 1.025, x, 0.0, nodes[t], states[:, t], 0) == HELD
            for t in range(POINTS)
        ]
    )
    assert not np.any(nodes["settled"] & (nodes["count"] > 0) & ~held)
    assert np.any(~held & (nodes["count"] > 0))
