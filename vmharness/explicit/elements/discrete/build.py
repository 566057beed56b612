"""The deck's springs and dampers -> forces of the model, part by part."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.define_sd_orientation import DEFINE_SD_ORIENTATION
from vmharness.deck.keywords.element_discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.section_discrete import SECTION_DISCRETE
from vmharness.explicit.elements.discrete.part import ABOUT, ALONG, Discrete
from vmharness.explicit.material import law_of
from vmharness.explicit.model import Model
from vmharness.explicit.parts import Part, parts
from vmharness.explicit.state import Array


def build(deck: Deck, model: Model) -> None:
    """Add a force for each part with discrete elements."""
    demand = {dro: np.zeros((2, model.ids.size)) for dro in (ALONG, ABOUT)}
    for part in parts(deck, model, (ELEMENT_DISCRETE,), SECTION_DISCRETE):
        law = law_of(part.material, "spring", part.part)
        constants = law.constants(deck, part.material)
        dro, size = part.section.dro, part.column("s")
        for total, bound in zip(demand[dro], law.bounds(constants), strict=True):
            for end in part.nodes.T:
                np.add.at(total, end[end >= 0], (bound * size)[end >= 0])
        model.forces.append(
            Discrete(
                name=f"springs and dampers of part {part.pid}",
                pid=part.pid,
                eid=part.eid,
                nodes=part.nodes,
                direction=_directions(deck, model, part),
                size=size,
                offset=part.column("offset"),
                dro=dro,
                law=law,
                constants=constants,
                demand=demand[dro],
            )
        )


def _directions(deck: Deck, model: Model, part: Part) -> Array:
    """Unit vectors (ne, 3) of the orientations that elements name, zero where they name none (VID = 0).

    Raises DeckError where an axis that shall follow the nodes is not given by them.
    """
    found = np.zeros((part.eid.size, 3))
    for i, vid in enumerate(part.column("vid").astype(int)):
        table, row = part.tables[part.table[i]], int(part.row[i])
        first, second = part.nodes[i]
        if vid:
            entry = deck.find(DEFINE_SD_ORIENTATION, vid=vid, referred_by=(table, "vid", row))
            vector = np.array([entry.xt, entry.yt, entry.zt])
            if not vector.any():
                raise entry.error("xt", "the vector XT, YT, ZT has no length")
            found[i] = vector / np.linalg.norm(vector)
        elif second < 0:
            raise table.error("vid", "an element to the ground (N2 = 0) needs an orientation", row)
        elif np.array_equal(model.x0[first], model.x0[second]):
            raise table.error("vid", "an element between nodes at one place needs an orientation", row)
    return found
