"""*LOAD_NODE_POINT, *LOAD_NODE_SET and *LOAD_RIGID_BODY: forces and moments on nodes and on centres of rigid bodies.

    f_i = SF LC(t)        DOF 1, 2, 3: force along x, y, z; DOF 5, 6, 7: moment about them

Every node of a set has the whole load. Directions are those of the global axes and do not rotate with the node. To the
time loop the centre of a rigid body is a node.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.keywords.load.rigid_body import LOAD_RIGID_BODY
from vmharness.deck.rule import above, among, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.curve import Curve, time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import lead_number
from vmharness.explicit.state import Array, Index, State
from vmharness.mesh.dof import place
from vmharness.mesh.sets import node_set

LOAD = {
    "dof": among(1, 2, 3, 5, 6, 7),
    "lcid": above(0),
    "cid": only(0),
    **{f"m{i}": only(0) for i in (1, 2, 3)},
}

SUPPORTS = tuple(supports(keyword, **LOAD) for keyword in (LOAD_NODE_POINT, LOAD_NODE_SET, LOAD_RIGID_BODY))

NAME = "nodal load"


def build(deck: Deck, model: Model) -> None:
    """Add a force for each *LOAD_RIGID_BODY, and one for all nodes that are loaded by the same curve."""
    for entry in deck.all(LOAD_RIGID_BODY):
        model.forces.append(_body_load(deck, model, entry))
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


def _body_load(deck: Deck, model: Model, entry: Entry) -> "NodalLoad":
    number = lead_number(deck, entry, "pid")
    return NodalLoad(
        name=f"load on rigid body {number}",
        nodes=np.array([model.centre(number)], np.intp),
        dofs=np.array([place(entry)]),
        scale=np.array([entry.sf]),
        curve=time_curve(deck, entry, "lcid", model.end_time),
    )


class NodalLoad:
    """f = SF LC(t) at pairs of node and degree of freedom (nl,), all under one curve."""

    def __init__(self, name: str, nodes: Index, dofs: Index, scale: Array, curve: Curve) -> None:
        self.name, self.nodes, self.dofs, self.scale, self.curve = name, nodes, dofs, scale, curve
        self.energy = {"external work": np.zeros(1)}
        self.now = curve(0.0)

    def add(self, state: State) -> None:
        """f += SF LC(t_n), and the work 1/2 SF (LC_n + LC_{n+1}) dt v_{n+1/2}."""
        before, self.now = self.now, self.curve(state.t)
        add_nodal_loads(
            state.f, state.moment, state.v, state.omega, self.nodes, self.dofs, self.scale,
            self.now, 0.5 * (before + self.now) * state.dt, self.energy["external work"],
        )  # fmt: skip


@kernel
def add_nodal_loads(
    f: Array, moment: Array, v: Array, omega: Array, nodes: Index, dofs: Index, scale: Array,
    now: float, impulse: float, work: Array,
) -> None:  # fmt: skip
    """Add `now` times `scale`, and the work of the step before; `impulse` is that of a unit load over this step."""
    for k in range(nodes.size):
        i, j = nodes[k], dofs[k]
        if j < 3:
            f[i, j] += scale[k] * now
            work[0] += scale[k] * impulse * v[i, j]
        else:
            moment[i, j - 3] += scale[k] * now
            work[0] += scale[k] * impulse * omega[i, j - 3]
