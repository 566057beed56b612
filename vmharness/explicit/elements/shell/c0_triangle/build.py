"""The deck's triangles with *SECTION_SHELL ELFORM = 2 -> forces and masses of the model."""

from vmharness.deck import Deck
from vmharness.explicit.elements.shell._build import add_part
from vmharness.explicit.elements.shell._parts import shell_parts
from vmharness.explicit.elements.shell.c0_triangle.part import C0Triangle
from vmharness.explicit.model.model import Model


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part that has such shells."""
    for part in shell_parts(deck, model, corners=3):
        add_part(deck, model, part, "triangles", C0Triangle)
