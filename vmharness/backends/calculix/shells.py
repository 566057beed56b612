"""Shells as S4, which CalculiX expands to solids C3D8I; S4R has hourglass modes, which nothing resists."""

import numpy as np

from vmharness.backends._translation.shells import shells
from vmharness.backends.calculix.materials import of
from vmharness.backends.calculix.model import Model, real
from vmharness.deck import Deck
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.mesh.faces import area_vectors

SUPPORTS = shells(
    elform="calculix: every shell is an S4",
    shrf="calculix: a shell is a solid of its thickness",
    nip="calculix: a shell has two points through the thickness",
)


def add(deck: Deck, model: Model) -> None:
    """Add the shells, and a section for each part."""
    sections: set[int] = set()
    for entry in deck.all(ELEMENT_SHELL):
        rows = model.nodes.corners(entry, entry.keyword.corners)
        areas = np.linalg.norm(area_vectors(model.nodes.x0[rows]), axis=1)
        for i, corners in enumerate(rows):
            if np.unique(corners).size < 4:
                raise entry.error("n4", "calculix: triangles are not supported", i)
            part = deck.find(PART, pid=int(entry.pid[i]), referred_by=(entry, "pid", i))
            section = deck.find(SECTION_SHELL, secid=part.secid, referred_by=(part, "secid"))
            material = deck.find(MAT_ELASTIC, mid=part.mid, referred_by=(part, "mid"))
            name = f"SHELL{part.pid}"
            model.add(entry.keyword, int(entry.eid[i]), "S4", name, corners)
            if part.pid not in sections:
                sections.add(part.pid)
                head = f"*SHELL SECTION,ELSET={name},MATERIAL={of(model, material)}"
                model.sections += [head, real(section.t1)]
            model.mass[corners] += 0.25 * material.ro * section.t1 * areas[i]
            stiffness = material.e * section.t1 / (1.0 - material.pr**2)
            for first, second in zip(corners, np.roll(corners, -1), strict=True):
                model.join(int(first), int(second), stiffness)
            model.expanded[corners] = model.rotating[corners] = True
            model.work += 1.0
            model.kicked = True
