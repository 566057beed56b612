"""Solids as SSPbrick, the stabilised brick of one integration point."""

import numpy as np

from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.solid import SECTION_SOLID
from vmharness.deck.rule import no_effect
from vmharness.deck.support import supports

SUPPORTS = (
    supports(ELEMENT_SOLID),
    supports(SECTION_SOLID, elform=no_effect("opensees: every solid is an SSPbrick")),
)


def add(deck: Deck, model: Model) -> None:
    """Add the solids, and a material for each *MAT_ELASTIC."""
    laws: dict[int, int] = {}
    for table in deck.all(ELEMENT_SOLID):
        rows = model.nodes.corners(table, table.keyword.corners)
        for i, corners in enumerate(rows):
            if np.unique(corners).size < 8:
                raise table.error("n8", "opensees: wedges and tetrahedra are not supported", i)
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            material = deck.find(MAT_ELASTIC, mid=part.mid, referred_by=(part, "mid"))
            if part.mid not in laws:
                laws[part.mid] = model.next()
                law = [laws[part.mid], material.e, material.pr, material.ro]
                model.materials.append(["nDMaterial", "ElasticIsotropic", *law])
            name = [int(table.eid[i]), *map(model.id, corners)]
            model.elements.append(["element", "SSPbrick", *name, laws[part.mid]])
            _lump(model, corners, material.e, material.pr, material.ro)


def _lump(model: Model, corners: np.ndarray, e: float, nu: float, rho: float) -> None:
    """Mass, and a stiffness for the critical step: that of bars along the edges with the modulus lambda + 2 mu."""
    x = model.nodes.x0[corners]
    edges = np.stack([x[[1, 2, 5, 6]] - x[[0, 3, 4, 7]], x[[3, 2, 7, 6]] - x[[0, 1, 4, 5]], x[4:] - x[:4]])
    sides = edges.mean(axis=1)  # (3, 3)
    volume = abs(float(np.linalg.det(sides)))
    model.used[corners] = True
    model.mass[corners] += rho * volume / 8.0
    modulus = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))
    model.stiff[corners] += 2.0 * modulus * volume / 4.0 * float((1.0 / (sides**2).sum(axis=1)).max())
