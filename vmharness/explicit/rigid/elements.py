"""Elements of parts with *MAT_RIGID: they have mass, and neither stress nor a stable step.

Each gives its nodes equal shares of its mass, rho t A of a shell, rho V of a solid, rho A L of a beam. Mass and inertia
of the body are sums over these nodes, as LS-DYNA makes them: a body of few elements has more inertia than its shape.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.elements import beam, shell, solid
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part
from vmharness.explicit.model.state import Array


def build(deck: Deck, model: Model) -> None:
    """Lump the mass of all such elements."""
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
    """rho volume (ne,) in equal shares to the corners."""
    count = part.nodes.shape[1]
    for corner in part.nodes.T:
        model.add_mass(corner, np.asarray(part.density * volume / count))
