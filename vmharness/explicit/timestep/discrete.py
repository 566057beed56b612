"""Springs and dampers at nodes of bars, shells and solids leave these the mass that they need: sum of m_e/h_e^2.

Here m_e is the mass (for torsional springs the rotary inertia) that an element gives to a node, and h_e its own stable
step; what follows for the step of the springs is in elements/discrete/limit.py. It is in fact a stiffness, which mass
scaling does not change: taken before that raises h_e, in the order of the modules' names.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.elements.discrete.part import Discrete
from vmharness.explicit.force import Scalable
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array


def build(deck: Deck, model: Model) -> None:
    """Set `taken` of the discrete elements."""
    discrete = [force for force in model.forces if isinstance(force, Discrete)]
    needs = {about: _need(model, about) for about in {force.about for force in discrete}}
    for force in discrete:
        force.taken = needs[force.about]


def _need(model: Model, about: bool) -> Array:
    """sum m_e/h_e^2 (n,), or that of rotary inertia."""
    need = np.zeros(model.ids.size)
    for block in model.forces:
        if isinstance(block, Scalable):
            share = (block.inertia if about else block.mass) / block.steps(model.state.x) ** 2
            for corner in block.nodes.T:
                np.add.at(need, corner, share)
    return need
