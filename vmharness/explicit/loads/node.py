"""*LOAD_NODE_POINT and *LOAD_NODE_SET: forces and moments on nodes.

    f_i = SF LC(t)        DOF 1, 2, 3: force along x, y, z; DOF 5, 6, 7: moment about them

Every node of a set takes the whole of it. Directions are those of the global axes and do not turn with the node.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.curve import Curve, time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array, State
from vmharness.mesh.dof import place
from vmharness.mesh.sets import node_set

NAME = "nodal load"

Index = NDArray[np.intp]


def build(deck: Deck, model: Model) -> None:
    """Add a force for each curve that loads nodes: a thousand nodes under one curve are one force."""
    loads: dict[int, list[tuple[Entry, Index]]] = {}
    for entry in deck.all(LOAD_NODE_POINT):
        rows = np.array([model.row(entry, "nid", entry.nid)], np.intp)
        loads.setdefault(entry.lcid, []).append((entry, rows))
    for entry in deck.all(LOAD_NODE_SET):
        loads.setdefault(entry.lcid, []).append((entry, node_set(deck, model, entry, "nsid")))
    for lcid, group in loads.items():
        curve = time_curve(deck, group[0][0], "lcid", model.end_time)
        nodes = np.concatenate([rows for _, rows in group])
        dofs = np.concatenate([np.full(rows.size, place(entry)) for entry, rows in group])
        scale = np.concatenate([np.full(rows.size, entry.sf) for entry, rows in group])
        model.forces.append(NodalLoad(f"nodal loads of curve {lcid}", nodes, dofs, scale, curve))


class NodalLoad:
    """f = SF LC(t) at pairs of node and degree of freedom (nl,), all under one curve."""

    def __init__(self, name: str, nodes: Index, dofs: Index, scale: Array, curve: Curve) -> None:
        self.name, self.nodes, self.dofs, self.scale, self.curve = name, nodes, dofs, scale, curve
        self.energy = {"external work": np.zeros(1)}
        self.now = curve(0.0)

    def add(self, state: State) -> None:
        """f += SF LC(t_n), and the work 1/2 SF (LC_n + LC_{n+1}) dt v_{n+1/2}."""
        before, self.now = self.now, self.curve(state.t)
        push(
            state.f, state.moment, state.v, state.omega, self.nodes, self.dofs, self.scale,
            self.now, 0.5 * (before + self.now) * state.dt, self.energy["external work"],
        )  # fmt: skip


@kernel
def push(
    f: Array, moment: Array, v: Array, omega: Array, nodes: Index, dofs: Index, scale: Array,
    now: float, impulse: float, work: Array,
) -> None:  # fmt: skip
    """Add `now` times `scale`; `impulse` is that of a unit load over the step that is over, with velocity v."""
    for k in range(nodes.size):
        i, j = nodes[k], dofs[k]
        if j < 3:
            f[i, j] += scale[k] * now
            work[0] += scale[k] * impulse * v[i, j]
        else:
            moment[i, j - 3] += scale[k] * now
            work[0] += scale[k] * impulse * omega[i, j - 3]
