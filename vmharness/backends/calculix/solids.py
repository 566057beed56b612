"""Solids as C3D8I, the brick with incompatible modes: C3D8 locks in bending, and C3D8R has hourglass modes."""

import numpy as np

from vmharness.backends.calculix.materials import of
from vmharness.backends.calculix.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.mat.plastic_kinematic import MAT_PLASTIC_KINEMATIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.solid import SECTION_SOLID
from vmharness.deck.rule import no_effect
from vmharness.deck.support import supports

SUPPORTS = (
    supports(ELEMENT_SOLID),
    supports(SECTION_SOLID, elform=no_effect("calculix: every solid is a C3D8I")),
)


def add(deck: Deck, model: Model) -> None:
    """Add the solids, and a section for each part."""
    sections: set[int] = set()
    for entry in deck.all(ELEMENT_SOLID):
        for i, corners in enumerate(model.nodes.corners(entry, entry.keyword.corners)):
            if np.unique(corners).size < 8:
                raise entry.error("n8", "calculix: wedges and tetrahedra are not supported", i)
            part = deck.find(PART, pid=int(entry.pid[i]), referred_by=(entry, "pid", i))
            material = deck.find(MAT_ELASTIC, MAT_PLASTIC_KINEMATIC, mid=part.mid, referred_by=(part, "mid"))
            name = f"SOLID{part.pid}"
            model.add(entry.keyword, int(entry.eid[i]), "C3D8I", name, corners)
            if part.pid not in sections:
                sections.add(part.pid)
                model.sections.append(f"*SOLID SECTION,ELSET={name},MATERIAL={of(model, material)}")
            _lump(model, corners, material.e, material.pr, material.ro)
            model.work += 1.0
            model.kicked = True


def _lump(model: Model, corners: np.ndarray, e: float, nu: float, rho: float) -> None:
    """Mass, and a stiffness for the critical step: that of bars along the edges with the modulus lambda + 2 mu."""
    x = model.nodes.x0[corners]
    edges = np.stack([x[[1, 2, 5, 6]] - x[[0, 3, 4, 7]], x[[3, 2, 7, 6]] - x[[0, 1, 4, 5]], x[4:] - x[:4]])
    sides = edges.mean(axis=1)  # (3, 3)
    volume = abs(float(np.linalg.det(sides)))
    model.mass[corners] += rho * volume / 8.0
    modulus = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))
    model.stiff[corners] += 2.0 * modulus * volume / 4.0 * float((1.0 / (sides**2).sum(axis=1)).max())
