"""Elements of parts with *MAT_RIGID: they have mass, but no stress, and they set no time step.

Each gives its nodes equal shares of its mass: rho t A of a shell, rho V of a solid, rho A L of a beam. Mass and inertia
of the body are sums over these nodes, as in LS-DYNA: a coarsely meshed body has more inertia than its shape has.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.elements import beam, shell, solid
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part
from vmharness.explicit.state import Array


def build(deck: Deck, model: Model) -> None:
    """Lump the mass of all elements of rigid parts at their nodes."""
    for corners in (4, 3):
        for part in shell.shell_parts(deck, model, corners):
            if part.rigid:
                _lump(model, part, shell.volume(part, model.x0))
    for elform in solid.ELFORMS:
        for part in solid.solid_parts(deck, model, elform):
            if part.rigid:
                _lump(model, part, solid.volume(part, model.x0))
    for elform in beam.ELFORMS:
        for part in beam.beam_parts(deck, model, elform):
            if part.rigid:
                _lump(model, part, beam.volume(part, model.x0))


def _lump(model: Model, part: Part, volume: Array) -> None:
    """Lump rho `volume` (ne,) in equal shares at the nodes of each element."""
    count = part.nodes.shape[1]
    for corner in part.nodes.T:
        model.add_mass(corner, np.asarray(part.density * volume / count))
