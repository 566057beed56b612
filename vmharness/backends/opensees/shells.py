"""Shells as ASDShellQ4 with an elastic membrane and plate section; the rotary inertia of the plate is at the nodes."""

import numpy as np

from vmharness.backends._translation.shells import shells
from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.mesh.faces import area_vectors

SUPPORTS = shells(
    elform="opensees: every shell is an ASDShellQ4",
    shrf="opensees: the shear factor is 5/6",
    nip="opensees: elastic shells need no points through the thickness",
)


def add(deck: Deck, model: Model) -> None:
    """Add the shells, and a section for each part."""
    sections: dict[int, int] = {}
    for table in deck.all(ELEMENT_SHELL):
        rows = model.nodes.corners(table, table.keyword.corners)
        areas = np.linalg.norm(area_vectors(model.nodes.x0[rows]), axis=1)
        for i, corners in enumerate(rows):
            if np.unique(corners).size < 4:
                raise table.error("n4", "opensees: triangles are not supported", i)
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            section = deck.find(SECTION_SHELL, secid=part.secid, referred_by=(part, "secid"))
            material = deck.find(MAT_ELASTIC, mid=part.mid, referred_by=(part, "mid"))
            if part.pid not in sections:
                sections[part.pid] = model.next()
                law = [sections[part.pid], material.e, material.pr, section.t1, material.ro]
                model.materials.append(["section", "ElasticMembranePlateSection", *law])
            model.elements.append(
                ["element", "ASDShellQ4", int(table.eid[i]), *map(model.id, corners), sections[part.pid]]
            )
            quarter = 0.25 * material.ro * section.t1 * areas[i]
            model.mass[corners] += quarter
            model.inertia[corners] += quarter * section.t1**2 / 12.0
            stiffness = material.e * section.t1 / (1.0 - material.pr**2)
            for first, second in zip(corners, np.roll(corners, -1), strict=True):
                model.join(int(first), int(second), stiffness)
            model.implicit = True
