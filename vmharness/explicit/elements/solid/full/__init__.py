"""Solid of eight nodes with 2 x 2 x 2 points (ELFORM 2) and the element's mean dilatation at all of them.

At a point the velocity gradient L gives the strain rate, whose trace is replaced by the mean over the volume:

    D = 1/2 (L + L^T) + 1/3 (tr L_mean - tr L) I

so that nearly incompressible material does not lock (selective reduced integration; T. J. R. Hughes, Generalization of
selective integration procedures to anisotropic and nonlinear media, International Journal for Numerical Methods in
Engineering 15 (1980) 1413-1418). Forces are the transpose. There are no hourglass modes. All points rotate with
the mean spin of the element. In bending, an element that is longer than thick is too stiff (shear locking), and a
single element through the depth of a beam is too soft, since its pressure is constant: a beam needs cubes, two or more
through its depth.
"""

from vmharness.deck import Deck
from vmharness.deck.error import each
from vmharness.explicit.elements.solid._build import add_part
from vmharness.explicit.elements.solid._parts import solid_parts
from vmharness.explicit.elements.solid.full.step import POINTS, step
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part

NAME = "fully integrated hexahedron"

ELFORM = 2


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part with *SECTION_SOLID ELFORM = 2."""

    def add(part: Part) -> None:
        if not part.rigid:
            add_part(deck, model, part, step, points=POINTS)

    each(solid_parts(deck, model, ELFORM), add)
