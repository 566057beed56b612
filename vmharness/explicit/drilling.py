"""Nodes of shells that nothing holds about the normal of the shells, while something turns them.

Shells of ELFORM 2 and C0 triangles have no stiffness against rotation of a node about their normal (drilling), in
LS-DYNA as here. Where all shells at a node lie in one plane, a moment about their normal accelerates the rotary inertia
of the node alone: it spins. Moments of *LOAD_NODE, ends of beams and torsional springs and dampers do that. Such nodes
are a fact of the run.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.force import Elements
from vmharness.explicit.loads.node import NodalLoad
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Flags
from vmharness.explicit.timestep.highest_mode import response

FLAT = 1e-3  # sum of sin^2 between normals, over their number: within 1.8 degrees
ALONG = 0.05  # a component of a unit normal that counts


def report_drilling(deck: Deck, model: Model) -> None:
    """Add a fact for the nodes that are free to turn about the normal of their shells, and are turned."""
    shells = [block for block in model.blocks if block.kind == "shell"]
    if not shells:
        return
    normal, flat = normals(model, shells)
    fixed = np.zeros((model.ids.size, 3), bool)
    for constraint in model.constraints:
        fixed |= constraint.fixed[:, 3:]
    free = flat & ~(fixed & (np.abs(normal) > ALONG)).any(axis=1)
    for name, turned in turning(model, normal):
        rows = np.flatnonzero(free & turned)
        if rows.size:
            others = f" and {rows.size - 1} other nodes" if rows.size > 1 else ""
            model.facts[f"Free rotation by {name}"] = (
                f"node {model.ids[rows[0]]}{others} can spin: the shells there do not resist rotation about their "
                "normal; support that rotation, or let an element that resists it end there"
            )


def normals(model: Model, shells: list[Elements]) -> tuple[Array, Flags]:
    """The normal (n, 3) of the shells at each node, zero where there are none, and whether they lie in one plane."""
    tensor = np.zeros((model.ids.size, 3, 3))
    for block in shells:
        x = model.state.x[block.nodes]
        a, b = (x[:, 2] - x[:, 0], x[:, -1] - x[:, 1])
        n = np.cross(a, b)
        n /= np.linalg.norm(n, axis=1, keepdims=True)
        for corner in block.nodes.T:
            np.add.at(tensor, corner, n[:, :, None] * n[:, None, :])
    values, axes = np.linalg.eigh(tensor)
    flat = (values[:, 2] > 0.0) & (values[:, 0] + values[:, 1] <= FLAT * values[:, 2])
    return np.where(flat[:, None], axes[:, :, 2], 0.0), flat


def turning(model: Model, normal: Array) -> list[tuple[str, Flags]]:
    """What acts on rotations about the normal (n, 3), by its name, and on which nodes (n,)."""
    found = []
    spin = np.zeros((model.ids.size, 6))
    spin[:, 3:] = normal * np.random.default_rng(0).uniform(0.5, 1.0, (model.ids.size, 1))
    for force in model.forces:
        if isinstance(force, NodalLoad):
            turned = np.zeros(model.ids.size, bool)
            moments = force.dofs >= 3
            rows = force.nodes[moments]
            turned[rows[np.abs(normal[rows, force.dofs[moments] - 3]) > ALONG]] = True
            found.append((force.name, turned))
        elif isinstance(force, Elements) and force.kind in ("beam", "discrete"):
            moment = np.sum(normal * response(model, [force], 1e-6 * spin, 1.0)[:, 3:], axis=1)
            found.append((force.name, np.abs(moment) > 1e-6 * np.abs(moment).max(initial=0.0)))
    return found
