"""Shells that are held at all nodes: surfaces for contacts. MuJoCo has no deformable shells of these elements.

They set the time step as in the deck: L/c, c = sqrt(E/(rho (1 - nu^2))), L the area over the longest side.
"""

import numpy as np

from vmharness.backends.mujoco.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.deck.support import supports
from vmharness.mesh.faces import area_vectors

SUPPORTS = (supports(ELEMENT_SHELL), supports(SECTION_SHELL), supports(MAT_ELASTIC))


def add(deck: Deck, model: Model) -> None:
    """Note the critical steps of the shells; raises DeckError for one with a node that is not held."""
    for table in deck.all(ELEMENT_SHELL):
        rows = model.nodes.corners(table, table.keyword.corners)
        for i, corners in enumerate(rows):
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            material = deck.find(MAT_ELASTIC, MAT_RIGID, mid=part.mid, referred_by=(part, "mid"))
            if material.keyword is MAT_RIGID:
                raise table.error("pid", "mujoco: rigid parts of shells are not represented", i)
            for name, row in zip(table.keyword.corners, corners, strict=True):
                if not model.held[row].all():
                    what = (
                        "mujoco: the node is not held in x, y and z; shells that deform are not represented"
                    )
                    raise table.error(name, what, i)
            speed = np.sqrt(material.e / (material.ro * (1.0 - material.pr**2)))
            x = model.nodes.x0[corners]
            sides = np.linalg.norm(x - np.roll(x, 1, axis=0), axis=1)
            area = np.linalg.norm(area_vectors(x[None])[0])
            model.steps.append(float(area / sides.max() / speed))
