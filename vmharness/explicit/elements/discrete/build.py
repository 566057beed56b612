"""The deck's springs and dampers -> forces of the model, part by part."""

from types import ModuleType
from typing import Any

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.sd_orientation import DEFINE_SD_ORIENTATION
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.section.discrete import SECTION_DISCRETE
from vmharness.deck.rule import above, among, anything, at_least, no_effect, only, where
from vmharness.deck.support import supports
from vmharness.explicit.elements.discrete.part import ABOUT, ALONG, Discrete, Orientation
from vmharness.explicit.materials import law_of
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part, parts
from vmharness.explicit.state import Array

SUPPORTS = (
    supports(
        ELEMENT_DISCRETE, n2=at_least(0), vid=at_least(0), s=above(0.0), pf=no_effect("affects output only")
    ),
    supports(
        SECTION_DISCRETE,
        dro=among(0, 1),
        kd=only(0.0),  # a damping in proportion to the force: no bound of the stable step is known beforehand
        v0=only(0.0, idle=lambda deck, entry: "" if entry.kd else "acts with KD"),
        cl=at_least(0.0),
        cdl=only(0.0),
        tdl=only(0.0),
    ),
    supports(
        DEFINE_SD_ORIENTATION,
        iop=among(0, 1, 2, 3),
        **{
            n: at_least(0, idle=where(lambda entry: entry.iop < 2, "acts with IOP = 2 or 3"))
            for n in ("nid1", "nid2")
        },
        **{
            x: anything(where(lambda entry: entry.iop > 1, "acts with IOP = 0 or 1"))
            for x in ("xt", "yt", "zt")
        },
    ),
)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each part with discrete elements."""
    demand = {dro: np.zeros((2, model.ids.size)) for dro in (ALONG, ABOUT)}
    for part in parts(deck, model, (ELEMENT_DISCRETE,), SECTION_DISCRETE):
        law = law_of(part.material, "spring", part.part)
        constants = law.constants(deck, part.material)
        dro, size = part.section.dro, part.column("s")
        _check_clearance(part, law, constants)
        for total, bound in zip(demand[dro], law.bounds(constants), strict=True):
            for end in part.nodes.T:
                np.add.at(total, end[end >= 0], (bound * size)[end >= 0])
        model.forces.append(
            Discrete(
                name=f"springs and dampers of part {part.pid}",
                pid=part.pid,
                eid=part.eid,
                nodes=part.nodes,
                orientation=_orientations(deck, model, part),
                limits=(part.section.cl, part.section.fd),
                size=size,
                offset=part.column("offset"),
                dro=dro,
                law=law,
                constants=constants,
                demand=demand[dro],
            )
        )


def _check_clearance(part: Part, law: ModuleType, constants: tuple[Any, ...]) -> None:
    """Clearance is defined for what depends on the elongation alone."""
    if part.section.cl and (law.HISTORY["spring"] or law.bounds(constants)[1]):
        raise part.section.error(
            "cl", f"not supported with *{part.material.keyword.name}: elastic springs are"
        )


def _orientations(deck: Deck, model: Model, part: Part) -> Orientation:
    """Of all elements; raises DeckError where an axis that shall follow the nodes is not given by them."""
    count = part.eid.size
    vector, guide = np.zeros((count, 3)), np.full((count, 3), (-1, -1, 0), np.intp)
    for i, vid in enumerate(part.column("vid").astype(int)):
        table, row = part.tables[part.table[i]], int(part.row[i])
        first, second = part.nodes[i]
        if vid:
            entry = deck.find(DEFINE_SD_ORIENTATION, vid=vid, referred_by=(table, "vid", row))
            vector[i], guide[i] = _oriented(model, entry)
        if second < 0 and (not vid or guide[i, 2]):
            raise table.error(
                "vid", "an element to the ground (N2 = 0) needs an orientation, IOP 0 or 2", row
            )
        r = model.x0[second] - model.x0[first]
        w = vector[i] if guide[i, 0] < 0 else model.x0[guide[i, 1]] - model.x0[guide[i, 0]]
        if guide[i, 2] and not np.linalg.norm(np.cross(r, w)) > 1e-12 * np.linalg.norm(r) * np.linalg.norm(w):
            raise table.error(
                "vid", "nothing of the element lies in the plane normal to its orientation", row
            )
        if not vid and not r.any():
            raise table.error("vid", "an element between nodes at one place needs an orientation", row)
    return vector, guide


def _oriented(model: Model, entry: Entry) -> tuple[Array, list[int]]:
    """The unit vector of an orientation, zero if nodes give it; these nodes or -1, and whether to project."""
    given = np.array([entry.xt, entry.yt, entry.zt])
    project = int(entry.iop in (1, 3))
    if entry.iop in (0, 1):
        if entry.nid1 or entry.nid2:
            raise entry.error("nid1" if entry.nid1 else "nid2", "only IOP = 2 and 3 have nodes")
        if not given.any():
            raise entry.error("xt", "the vector XT, YT, ZT has no length")
        return given / np.linalg.norm(given), [-1, -1, project]
    if given.any():
        raise entry.error("iop", "takes the direction between its nodes, not XT, YT, ZT")
    ends = [model.row(entry, name, getattr(entry, name)) for name in ("nid1", "nid2")]
    if np.array_equal(model.x0[ends[0]], model.x0[ends[1]]):
        raise entry.error("nid2", "lies where NID1 is: there is no direction between them")
    return np.zeros(3), [*ends, project]
