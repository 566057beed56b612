"""What a tracked node has from the facets at it: penalty stiffness, thickness, tributary area."""

import numpy as np

from vmharness.explicit.contact.surface.facets import Facets, area
from vmharness.explicit.state import Array, Index
from vmharness.mesh.surface import exterior


def nodal_penalty(every: Facets, tracked: Index, nodes: int) -> Array:
    """The largest k (nt,) of the facets at each tracked node; infinite where it has none. The model has `nodes`."""
    largest = _largest(every, every.penalty, nodes)[tracked]
    return np.where(largest > 0.0, largest, np.inf)


def nodal_thickness(every: Facets, thickness: Array, tracked: Index, nodes: int) -> Array:
    """The largest `thickness` (n,) of the facets at each tracked node (nt,), 0 where it has none."""
    return _largest(every, thickness, nodes)[tracked]


def nodal_area(every: Facets, x: Array, tracked: Index) -> Array:
    """The tributary area (nt,): the node's share of shells and outer faces of solids; infinite where it has none."""
    outer = every.only(exterior(every))
    triangle = outer.nodes[:, 2] == outer.nodes[:, 3]
    share, total = area(x[outer.nodes]) / np.where(triangle, 3.0, 4.0), np.zeros(x.shape[0])
    for corner in range(4):
        there = slice(None) if corner < 3 else ~triangle
        np.add.at(total, outer.nodes[there, corner], share[there])
    return np.where(total[tracked] > 0.0, total[tracked], np.inf)


def _largest(every: Facets, values: Array, nodes: int) -> Array:
    largest = np.zeros(nodes)
    np.maximum.at(largest, every.nodes, values[:, None])
    return largest
