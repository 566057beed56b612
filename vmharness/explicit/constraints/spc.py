"""*BOUNDARY_SPC_NODE, *BOUNDARY_SPC_SET and the constraint codes of *NODE: fixed degrees of freedom."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.boundary.spc import BOUNDARY_SPC_NODE, BOUNDARY_SPC_SET, DOFS
from vmharness.deck.keywords.node import NODE
from vmharness.deck.rule import among, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Flags, Index, State
from vmharness.mesh.supports import supported

CODE = among(*range(8))
DIRECTIONS = {"cid": only(0), **{dof: among(0, 1) for dof in DOFS}}

SUPPORTS = (
    supports(NODE, tc=CODE, rc=CODE),
    supports(BOUNDARY_SPC_NODE, **DIRECTIONS),
    supports(BOUNDARY_SPC_SET, **DIRECTIONS),
)


def build(deck: Deck, model: Model) -> None:
    """Add one constraint for all supports of the deck, if it has any."""
    fixed = supported(deck, model)
    if fixed.any():
        model.state.v[fixed[:, :3]] = 0.0  # a support overrules an initial velocity
        model.state.omega[fixed[:, 3:]] = 0.0
        model.constraints.append(Supports(fixed))


class Supports:
    """Fixed degrees of freedom: a = 0, with the reaction r = -f."""

    name = "supports"

    def __init__(self, fixed: Flags) -> None:
        """`fixed` is (n, 6): x, y, z and the rotations about them, for every node."""
        self.energy: dict[str, Array] = {}  # fixed nodes do no work
        self.fixed = fixed
        self.nodes, self.dofs = np.nonzero(fixed)
        self.reaction = np.zeros((fixed.shape[0], 6))  # (n, 6) force and moment of the supports on the nodes
        self.total = np.zeros(6)  # their sum; each moment is that about its own node

    def accelerate(self, state: State) -> None:
        """Set a = 0 and r = -f at the fixed degrees of freedom."""
        fix(self.nodes, self.dofs, self.reaction, self.total, state.f, state.moment, state.a, state.alpha)

    def move(self, state: State, dt: float) -> None:
        """Nothing to do: the velocity is zero from the start, and is not accelerated."""


@kernel
def fix(
    nodes: Index, dofs: Index, reaction: Array, total: Array, f: Array, moment: Array, a: Array, alpha: Array
) -> None:
    """Set r = -f, a = 0 for each pair of node and degree of freedom."""
    total[:] = 0.0
    for k in range(nodes.size):
        i, j = nodes[k], dofs[k]
        if j < 3:
            reaction[i, j] = -f[i, j]
            a[i, j] = 0.0
        else:
            reaction[i, j] = -moment[i, j - 3]
            alpha[i, j - 3] = 0.0
        total[j] += reaction[i, j]
