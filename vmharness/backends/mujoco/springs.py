"""*ELEMENT_DISCRETE as tendons: the force acts along the line between the nodes, as there.

An initial elongation OFFSET becomes a rest length that is shorter than the distance of the nodes.
"""

from vmharness.backends._translation import springs
from vmharness.backends.mujoco.model import Model, Tendon
from vmharness.deck import Deck
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.keywords.mat.spring_elastic import MAT_SPRING_ELASTIC
from vmharness.deck.keywords.part import PART

SUPPORTS = springs.SUPPORTS


def add(deck: Deck, model: Model) -> None:
    """Add a tendon for each spring and damper; raises DeckError for one that has no length."""
    for table in deck.all(ELEMENT_DISCRETE):
        rows = model.nodes.corners(table, table.keyword.corners)
        for i, (first, second) in enumerate(rows.tolist()):
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            material = deck.find(
                MAT_SPRING_ELASTIC, MAT_DAMPER_VISCOUS, mid=part.mid, referred_by=(part, "mid")
            )
            spring = material.keyword is MAT_SPRING_ELASTIC
            k, c = (material.k, 0.0) if spring else (0.0, material.dc)
            length = model.length(first, second)
            if length == 0.0:
                raise table.error("n2", "mujoco: a spring between nodes at one place has no direction", i)
            rest = length - float(table.offset[i]) if spring else length
            if rest < 0.0:
                raise table.error(
                    "offset", "mujoco: it is longer than the spring, whose rest length would be negative", i
                )
            size = float(table.s[i])
            model.used[[first, second]] = True
            model.tendons.append(Tendon(int(table.eid[i]), (first, second), size * k, size * c, rest))
