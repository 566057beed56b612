"""Beams and trusses of the deck, part by part, with their lengths and orientations."""

from collections.abc import Iterator

import numpy as np

from vmharness.deck import Deck, DeckError
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.section.beam import SECTION_BEAM
from vmharness.deck.rule import above, always, among, at_least, no_effect, only
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part, parts
from vmharness.explicit.state import Array

ELFORMS = {2: "Belytschko-Schwer beam", 3: "truss"}

RELEASES = {
    **{name: only(0) for name in ("rt1", "rr1", "rt2", "rr2")},
    "local": among(1, 2, alike=always("is of releases, of which there are none")),
}
INTEGRATED = no_effect("acts on beams that are integrated over the cross-section")

SUPPORTS = (
    supports(ELEMENT_BEAM, n3=at_least(0), **RELEASES),
    supports(ELEMENT_BEAM_ORIENTATION, n3=only(0), **RELEASES),
    supports(
        SECTION_BEAM,
        elform=among(*ELFORMS),
        shrf=INTEGRATED,
        qr=INTEGRATED,
        cst=INTEGRATED,
        scoor=only(0.0),
        nsm=only(0.0),
        naupd=only(0),
        **{name: above(0.0) for name in ("a", "iss", "itt", "j")},
        sa=at_least(0.0),
        **{name: only(0.0) for name in ("ist", "itorm", "sat", "rampt", "stress")},
    ),
)


def beam_parts(deck: Deck, model: Model, elform: int) -> Iterator[Part]:
    """Every part of beams with this formulation."""
    for part in parts(deck, model, (ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION), SECTION_BEAM):
        if part.section.elform == elform:
            yield part


def lengths(part: Part, x: Array) -> Array:
    """Length (ne,) of the elements at coordinates `x` (n, 3); raises DeckError where there is none."""
    length = np.linalg.norm(x[part.nodes[:, 1]] - x[part.nodes[:, 0]], axis=1)
    for i in np.flatnonzero(length == 0.0):
        raise _error(part, int(i), "n2", "lies where the first node is: the element has no length")
    return np.asarray(length)


def volume(part: Part, x: Array) -> Array:
    """Area of the section times length (ne,) at coordinates `x` (n, 3)."""
    return np.asarray(part.section.a * lengths(part, x))


def orientations(part: Part, model: Model) -> Array:
    """Vectors (ne, 3) from node 1 in the r-s plane: to node 3, or VX, VY, VZ; raises DeckError along the axis."""
    third = [model.find(table, "n3", np.where(table.n3 > 0, table.n3, table.n1)) for table in part.tables]
    n3 = np.array([third[t][r] for t, r in zip(part.table, part.row, strict=True)])
    own = np.column_stack([part.column(name) for name in ("vx", "vy", "vz")])
    vector = model.x0[n3] - model.x0[part.nodes[:, 0]] + own
    axis = model.x0[part.nodes[:, 1]] - model.x0[part.nodes[:, 0]]
    across = np.linalg.norm(np.cross(axis, vector), axis=1)
    for i in np.flatnonzero(~(across > 1e-9 * np.linalg.norm(axis, axis=1) * np.linalg.norm(vector, axis=1))):
        raise _error(part, int(i), "n3", "a beam needs a third node, or a vector, that lies off its axis")
    return np.asarray(vector)


def _error(part: Part, element: int, field: str, what: str) -> DeckError:
    return part.tables[part.table[element]].error(field, what, int(part.row[element]))
