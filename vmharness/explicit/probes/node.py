"""Motion of a node."""

import numpy as np

from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe, ProbeError, choose, of_point, split

KEYS = ("node",)


def probe(model: Model, node: int, component: str) -> Probe:
    """A component of the motion of a node at t_n: `z-displacement`, `x-velocity`, `y-acceleration`, `z-coordinate`."""
    rows = np.flatnonzero((model.ids == node) & (model.ids > 0))
    if not rows.size:
        raise ProbeError(f"no node {node} in the deck")
    axis, quantity = split(component)
    return choose(of_point(model, int(rows[0]), axis), quantity, "of a node")
