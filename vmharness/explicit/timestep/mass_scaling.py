"""*CONTROL_TIMESTEP DT2MS < 0: mass added where the time step is small.

An element whose stable step h is below |DT2MS| has its density, and with it mass and rotary inertia, raised by

    phi = (|DT2MS| / h)^2        h = L/c, c ~ 1/sqrt(density)

so that its step becomes |DT2MS|, and the run's TSSFAC |DT2MS|. It is done once, at the beginning: MS1ST = 1. What is
added is a fact of the run. (LS-DYNA keyword manual, *CONTROL_TIMESTEP.)
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.control_timestep import CONTROL_TIMESTEP
from vmharness.explicit.force import Elements, Scalable
from vmharness.explicit.model import Model


def build(deck: Deck, model: Model) -> None:
    """Raise densities, and say by how much the mass of each part grew."""
    control = deck.first(CONTROL_TIMESTEP)
    if control is None or control.dt2ms == 0.0:
        return
    if control.dt2ms > 0.0:
        raise control.error("dt2ms", "one step for all elements is not supported; a negative value is")
    if control.ms1st != 1:
        raise control.error(
            "ms1st", "mass scaling during the run is not supported; with MS1ST = 1 it is done once"
        )
    for block in [force for force in model.forces if isinstance(force, Elements)]:
        if not isinstance(block, Scalable):
            raise control.error(
                "dt2ms", f"mass scaling of {block.name} is not implemented; supported: shells, solids"
            )
        _scale(model, block, -control.dt2ms)


def _scale(model: Model, block: Scalable, step: float) -> None:
    phi = np.maximum((step / block.steps(model.state.x)) ** 2, 1.0)
    block.densify(phi)
    for corner in block.nodes.T:
        model.add_mass(corner, (phi - 1.0) * block.mass, (phi - 1.0) * block.inertia)
    corners, own = block.nodes.shape[1], block.mass.sum()
    added = float((phi - 1.0) @ block.mass)
    if added:
        model.facts[f"Mass added to {block.name}"] = (
            f"{corners * added:.6g} ({100.0 * added / own:.4g} %), at {(phi > 1.0).sum()} of {phi.size} elements"
        )
