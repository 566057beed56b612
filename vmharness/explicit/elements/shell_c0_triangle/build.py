"""The deck's triangles with *SECTION_SHELL ELFORM = 2 -> forces and masses of the model."""

from vmharness.deck import Deck
from vmharness.explicit.elements.shell_c0_triangle.part import C0Triangle
from vmharness.explicit.model import Model
from vmharness.explicit.shell.build import add_part
from vmharness.explicit.shells import shell_parts


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part that has such shells."""
    for part in shell_parts(deck, model, corners=3):
        add_part(deck, model, part, "triangles", C0Triangle)
