"""Elements of parts with *MAT_RIGID: they have mass, and neither stress nor a step.

Each gives its nodes equal shares of its mass, rho t A of a shell, rho V of a solid, rho A L of a beam. Mass and inertia
of the body are sums over these nodes, as LS-DYNA makes them: a body of few elements has more inertia than its shape.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.elements.beam._parts import beam_parts, lengths
from vmharness.explicit.elements.shell._parts import shell_parts, thickness
from vmharness.explicit.elements.shell.belytschko_tsay.mass import area as quadrilateral
from vmharness.explicit.elements.shell.c0_triangle.mass import area as triangle
from vmharness.explicit.elements.solid._gradient import measures
from vmharness.explicit.elements.solid._parts import SUPPORTED, solid_parts
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part
from vmharness.explicit.model.state import Array


def build(deck: Deck, model: Model) -> None:
    """Lump the mass of all such elements."""
    x = model.x0
    for corners, area in ((4, quadrilateral), (3, triangle)):
        for part in shell_parts(deck, model, corners):
            if part.rigid:
                _lump(model, part, thickness(part) * area(x[part.nodes]))
    for elform in SUPPORTED:
        for part in solid_parts(deck, model, elform):
            if part.rigid:
                _lump(model, part, measures(x[part.nodes])[0])
    for elform in (2, 3):
        for part in beam_parts(deck, model, elform):
            if part.rigid:
                _lump(model, part, part.section.a * lengths(part, x))


def _lump(model: Model, part: Part, volume: Array) -> None:
    """rho volume (ne,) in equal shares to the corners."""
    count = part.nodes.shape[1]
    for corner in part.nodes.T:
        model.add_mass(corner, np.asarray(part.density * volume / count))
