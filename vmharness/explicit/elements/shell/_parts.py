"""Shells of the deck, part by part, with their thickness, area and volume."""

from collections.abc import Iterator

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.deck.rule import at_least, only
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part, parts
from vmharness.explicit.state import Array

CONNECTIVITY = {"n4": at_least(0), **{f"n{i}": only(0) for i in range(5, 9)}}

SUPPORTS = (
    supports(ELEMENT_SHELL, **CONNECTIVITY),
    supports(
        ELEMENT_SHELL_THICKNESS,
        **CONNECTIVITY,
        **{f"thic{i}": at_least(0.0) for i in range(1, 5)},
        beta=only(0.0),
    ),
)


def shell_parts(deck: Deck, model: Model, corners: int) -> Iterator[Part]:
    """Every part that has shells of four or of three `corners`, with these alone; a triangle has N4 = N3 or 0."""
    for part in parts(deck, model, (ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS), SECTION_SHELL):
        third, fourth = part.nodes[:, 2:].T
        chosen = ((fourth == third) | (fourth < 0)) == (corners == 3)
        if not chosen.any():
            continue
        part = part.only(chosen, corners)
        ordered = np.sort(part.nodes, axis=1)
        for i in np.flatnonzero((ordered[:, 1:] == ordered[:, :-1]).any(axis=1)):
            table = part.tables[part.table[i]]
            raise table.error("n1", "has a node twice; a triangle repeats its third as N4", int(part.row[i]))
        yield part


def area(corners: Array) -> Array:
    """Area (ne,) of shells with `corners` (ne, 4, 3) or (ne, 3, 3): |r13 x r24| / 2, |r21 x r31| / 2."""
    a, b = (0, 2), (1, 3)
    if corners.shape[1] == 3:
        a, b = (1, 0), (2, 0)
    first, second = (corners[:, i] - corners[:, j] for i, j in (a, b))
    return np.asarray(0.5 * np.linalg.norm(np.cross(first, second), axis=1))


def volume(part: Part, x: Array) -> Array:
    """Thickness times area (ne,) at coordinates `x` (n, 3)."""
    return thickness(part) * area(x[part.nodes])


def thickness(part: Part) -> Array:
    """Mean of the nodal thicknesses (ne,): those of the element where it gives them, else those of the section."""
    section, corners = part.section, part.nodes.shape[1]
    usual = [section.t1, *(t if t > 0.0 else section.t1 for t in (section.t2, section.t3, section.t4))]
    own = np.column_stack([part.column(f"thic{i}") for i in range(1, corners + 1)])
    mean = np.where(own > 0.0, own, usual[:corners]).mean(axis=1)
    if not np.all(mean > 0.0):
        raise section.error("t1", "a shell needs a thickness greater than 0")
    return np.asarray(mean)
