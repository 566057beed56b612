"""What is near a node: against looking at everything."""

import numpy as np
import pytest

from vmharness.explicit.contact.neighbours import find_neighbours
from vmharness.explicit.contact.records import node_records, segment_records
from vmharness.explicit.contact.search import find_candidates


def test_neighbours_share_a_node(scene, bench):
    nodes = scene.sheet(bench.flat, range(4), range(4))
    first, found = find_neighbours(nodes)
    for s, own in enumerate(nodes):
        shared = {q for q, other in enumerate(nodes) if q != s and set(other) & set(own)}
        assert sorted(found[first[s] : first[s + 1]]) == sorted(shared)


@pytest.mark.parametrize("reach", [0.05, 0.4])
def test_buckets_find_all_that_is_near_and_each_once(scene, bench, reach):
    rng = np.random.default_rng(1)
    small = scene.sheet(lambda a, b: (a, b, 0.3 * a * b), np.linspace(0, 1, 9), np.linspace(0, 1, 7))
    large = scene.sheet(bench.flat, [-40.0, 50.0], [-40.0, 50.0])
    cloud = scene.nodes(np.concatenate([rng.uniform(-0.5, 1.5, (300, 3)), [[1e6, -1e7, 3.0]]]))
    own = np.unique(small)  # nodes that are corners themselves
    x = scene.state().x
    nodes = node_records(bench.tracked(np.concatenate([cloud, own]), thickness=0.02))
    segments = segment_records(bench.segments(np.concatenate([small, large]), thickness=0.04))
    first, found = find_candidates(x, nodes, segments, reach)
    box = x[segments["nodes"]]
    for t, row in enumerate(nodes["row"]):
        apart = np.maximum(np.maximum(box.min(axis=1) - x[row], x[row] - box.max(axis=1)), 0.0)
        distance = np.linalg.norm(apart, axis=1)
        near = (distance <= reach + 0.03) & ~(segments["nodes"] == row).any(axis=1)
        assert found[first[t] : first[t + 1]].tolist() == np.flatnonzero(near).tolist()
