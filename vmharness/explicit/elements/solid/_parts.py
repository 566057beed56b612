"""Solids of the deck, part by part, with their volume and bulk viscosity."""

from collections.abc import Iterator

import numpy as np

from vmharness.deck import Deck, DeckError, Entry
from vmharness.deck.keywords.control.bulk_viscosity import CONTROL_BULK_VISCOSITY
from vmharness.deck.keywords.control.solid import CONTROL_SOLID
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.deck.keywords.section.solid import SECTION_SOLID
from vmharness.deck.rule import at_least, implemented, no_effect, only, unless, without_parts
from vmharness.deck.support import supports
from vmharness.explicit.elements.solid._gradient import measures
from vmharness.explicit.model import contents
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part, parts
from vmharness.explicit.state import Array

Q1, Q2 = 1.5, 0.06
ELFORMS = {1: "one point", 2: "fully integrated"}


def _type_of_shells(deck: Deck, entry: Entry) -> str:
    without = entry.type == -1 and not contents.shells(deck)
    return "acts on shells, of which the deck has none" if without else ""


SUPPORTS = (
    supports(ELEMENT_SOLID, n9=only(0), n10=only(0)),
    supports(
        SECTION_SOLID,
        elform=implemented(ELFORMS, idle=without_parts),
        aet=only(0),
        cohoff=only(0.0),
        gaskett=only(0.0),
    ),
    supports(
        CONTROL_BULK_VISCOSITY,
        **{q: at_least(0.0, idle=unless(contents.solids, "the deck has no solids")) for q in ("q1", "q2")},
        type=only(1, idle=_type_of_shells),
        btype=only(0, idle=unless(contents.beams, "the deck has no beams")),
        tstype=no_effect("acts on thick shells"),
    ),
    supports(
        CONTROL_SOLID,
        unless(contents.solids, "the deck has no solids"),
        esort=only(0, idle=unless(contents.wedges, "no solid is degenerate")),
        fmatrx=no_effect("another way to the same deformation gradient"),
        niptets=no_effect("acts on tetrahedra"),
        swlocl=no_effect("affects output only"),
        psfail=only(0),
        t10jtol=no_effect("acts on tetrahedra"),
        icoh=no_effect("acts on cohesive elements"),
        tet13k=no_effect("acts on tetrahedra"),
        **{f"pm{i}": no_effect("acts on tetrahedra of ten nodes") for i in range(1, 11)},
        tet13v=no_effect("acts on tetrahedra"),
        rinrt=no_effect("acts on solids that can rotate"),
        coheqc=no_effect("acts on cohesive elements"),
    ),
)


def solid_parts(deck: Deck, model: Model, elform: int) -> Iterator[Part]:
    """Every part that has solids of this formulation; raises DeckError for what no formulation can do."""
    for part in parts(deck, model, (ELEMENT_SOLID,), SECTION_SOLID):
        if part.section.elform not in ELFORMS:
            able = ", ".join(f"{number} ({what})" for number, what in ELFORMS.items())
            raise part.section.error("elform", f"not implemented; supported: {able}")
        if part.section.elform == elform:
            _check_shapes(part, model)
            yield part


def volume(part: Part, x: Array) -> Array:
    """Volume (ne,) at coordinates `x` (n, 3)."""
    return measures(x[part.nodes])[0]


def bulk_viscosity(deck: Deck, part: Entry) -> tuple[float, float]:
    """Q1 and Q2: *HOURGLASS of the part, else *CONTROL_BULK_VISCOSITY, else 1.5 and 0.06."""
    if part.hgid:
        own = deck.find(HOURGLASS, hgid=part.hgid, referred_by=(part, "hgid"))
        return own.q1, own.q2
    control = deck.first(CONTROL_BULK_VISCOSITY)
    return (control.q1, control.q2) if control else (Q1, Q2)


def _check_shapes(part: Part, model: Model) -> None:
    """Eight different nodes, or a wedge 1 2 3 4 5 5 6 6; a volume greater than 0."""
    n = part.nodes
    different = 1 + (np.diff(np.sort(n, axis=1), axis=1) > 0).sum(axis=1)
    wedge = (different == 6) & (n[:, 4] == n[:, 5]) & (n[:, 6] == n[:, 7])
    for i in np.flatnonzero((different < 8) & ~wedge).tolist():
        what = "a tetrahedron" if different[i] == 4 else "nodes repeat"
        raise _error(part, i, f"{what}; supported: eight different nodes, and wedges n1 n2 n3 n4 n5 n5 n6 n6")
    for i in np.flatnonzero(~(volume(part, model.x0) > 0.0)).tolist():
        raise _error(
            part, i, "the solid has no volume, or is inside out: nodes 1 to 4, seen from 5 to 8, turn left"
        )


def _error(part: Part, element: int, what: str) -> DeckError:
    return part.tables[part.table[element]].error("n1", what, int(part.row[element]))
