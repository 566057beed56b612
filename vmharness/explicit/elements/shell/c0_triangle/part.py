"""C0 triangles: those of one part as a force, and from the deck."""

from typing import Any

from vmharness.deck import Deck
from vmharness.deck.error import each
from vmharness.explicit.elements.shell._build import add_part
from vmharness.explicit.elements.shell._formulation import Formulation
from vmharness.explicit.elements.shell._parts import shell_parts
from vmharness.explicit.elements.shell._shells import Shells
from vmharness.explicit.elements.shell.c0_triangle.frame import load_corners
from vmharness.explicit.elements.shell.c0_triangle.length import LENGTHS
from vmharness.explicit.elements.shell.c0_triangle.mass import nodal_mass
from vmharness.explicit.elements.shell.c0_triangle.step import force, no_hourglass, strain
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part

TRIANGLE = Formulation(nodal_mass, load_corners, LENGTHS, strain, no_hourglass, force)


class C0Triangle(Shells):
    """Shells (ne, 3), see shell/_shells.py."""

    def __init__(self, *given: Any, **options: Any) -> None:
        super().__init__(TRIANGLE, *given, **options)


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part that has such shells."""

    def add(part: Part) -> None:
        add_part(deck, model, part, "triangles", C0Triangle)

    each(shell_parts(deck, model, corners=3), add)
