"""Shells of the deck, part by part, with their thickness."""

from collections.abc import Iterator

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.element_shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.section_shell import SECTION_SHELL
from vmharness.explicit.model import Model
from vmharness.explicit.parts import Part, parts
from vmharness.explicit.state import Array


def shell_parts(deck: Deck, model: Model) -> Iterator[Part]:
    """Every part that has shells."""
    for part in parts(deck, model, (ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS), SECTION_SHELL):
        corners = np.sort(part.nodes, axis=1)
        for i in np.flatnonzero((corners[:, 1:] == corners[:, :-1]).any(axis=1)):
            raise part.tables[part.table[i]].error(
                "n4",
                "a triangle; only quadrilaterals with four different nodes are supported",
                int(part.row[i]),
            )
        yield part


def thickness(part: Part) -> Array:
    """Mean of the nodal thicknesses (ne,): the element's own where it gives one, else the section's."""
    section = part.section
    usual = [section.t1, *(t if t > 0.0 else section.t1 for t in (section.t2, section.t3, section.t4))]
    own = np.column_stack([part.column(f"thic{i}") for i in range(1, 5)])
    mean = np.where(own > 0.0, own, usual).mean(axis=1)
    if not np.all(mean > 0.0):
        raise section.error("t1", "a shell needs a thickness greater than 0")
    return np.asarray(mean)
