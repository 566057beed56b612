"""*ELEMENT_BEAM with ELFORM 3: elastic trusses as tendons with half of their mass at each node, or rigid ones.

Elastic ones have the critical step L/c, c = sqrt(E/rho), whatever other masses are at their nodes.
"""

import numpy as np

from vmharness.backends.mujoco.damping import stiffness_time
from vmharness.backends.mujoco.model import Model, Tendon
from vmharness.deck import Deck
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.beam import SECTION_BEAM
from vmharness.deck.rule import implemented, only
from vmharness.deck.support import supports

TRUSS = 3  # ELFORM
SUPPORTS = (
    supports(ELEMENT_BEAM, **{name: only(0) for name in ("rt1", "rr1", "rt2", "rr2")}),
    supports(SECTION_BEAM, elform=implemented({TRUSS: "truss"}), stress=only(0.0), rampt=only(0.0)),
)


def add(deck: Deck, model: Model) -> None:
    """Add masses of trusses to their nodes, and a tendon of the stiffness E A/L for each that is not rigid."""
    for table in deck.all(ELEMENT_BEAM):
        rows = model.nodes.corners(table, table.keyword.corners)
        for i, ends in enumerate(rows):
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            section = deck.find(SECTION_BEAM, secid=part.secid, referred_by=(part, "secid"))
            material = deck.find(MAT_ELASTIC, MAT_RIGID, mid=part.mid, referred_by=(part, "mid"))
            first, second = map(int, ends)
            length = model.length(first, second)
            model.used[ends] = True
            np.add.at(model.mass, ends, 0.5 * material.ro * section.a * length)
            if material.keyword is MAT_ELASTIC:
                stiffness = material.e * section.a / length
                damping = stiffness_time(deck, part.pid) * stiffness
                model.steps.append(length * float(np.sqrt(material.ro / material.e)))
                model.tendons.append(Tendon(int(table.eid[i]), (first, second), stiffness, damping, length))
