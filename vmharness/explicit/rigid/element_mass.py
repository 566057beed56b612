"""Elements of parts with *MAT_RIGID: they have mass, but no stress.

Each gives its nodes equal shares of its mass: rho t A of a shell, rho V of a solid, rho A L of a beam. Mass and inertia
of the body are sums over these nodes, as in LS-DYNA: a coarsely meshed body has more inertia than its shape has.

They limit no time step. But where nothing else in the model does, the step is the one that they would allow if they
were elastic, L/c with E and PR of *MAT_RIGID: see timestep/limits.py.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.elements import beam, shell, solid
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part
from vmharness.explicit.state import Array


def build(deck: Deck, model: Model) -> None:
    """Lump the mass of all elements of rigid parts at their nodes."""
    x = model.x0
    for corners in (4, 3):
        for part in shell.shell_parts(deck, model, corners):
            if part.rigid:
                _lump(model, part, shell.volume(part, x))
                sides = np.linalg.norm(x[part.nodes] - x[np.roll(part.nodes, 1, axis=1)], axis=2)
                length = (5 - corners) * shell.area(x[part.nodes]) / sides.max(axis=1)
                _limit(model, part, length, part.moduli.E / (1.0 - part.moduli.nu**2))
    for elform in solid.ELFORMS:
        for part in solid.solid_parts(deck, model, elform):
            if part.rigid:
                _lump(model, part, solid.volume(part, x))
                _limit(model, part, solid.measures(x[part.nodes])[2], part.moduli.longitudinal)
    for elform in beam.ELFORMS:
        for part in beam.beam_parts(deck, model, elform):
            if part.rigid:
                _lump(model, part, beam.volume(part, x))
                _limit(model, part, beam.lengths(part, x), part.moduli.E)


def _lump(model: Model, part: Part, volume: Array) -> None:
    """Lump rho `volume` (ne,) in equal shares at the nodes of each element."""
    count = part.nodes.shape[1]
    for corner in part.nodes.T:
        model.add_mass(corner, np.asarray(part.density * volume / count))


def _limit(model: Model, part: Part, length: Array, modulus: float) -> None:
    """Keep the shortest L/c of rigid elements, with `length` (ne,) and rho c^2 = `modulus`."""
    step = float(length.min()) * (part.density / modulus) ** 0.5
    model.rigid_step = min(model.rigid_step, step)
