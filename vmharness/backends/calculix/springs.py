"""*ELEMENT_DISCRETE as SPRINGA and DASHPOTA: the force acts along the line between the nodes, as there.

An initial elongation OFFSET moves the force curve of a SPRINGA by it.
"""

import numpy as np

from vmharness.backends._translation import springs
from vmharness.backends.calculix.model import Lines, Model, real, table
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.keywords.mat.spring_elastic import MAT_SPRING_ELASTIC
from vmharness.deck.keywords.mat.spring_nonlinear_elastic import MAT_SPRING_NONLINEAR_ELASTIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import only
from vmharness.deck.support import supports

SUPPORTS = (*springs.SUPPORTS, supports(MAT_SPRING_NONLINEAR_ELASTIC, lcr=only(0)))
FAR = 100.0  # a straight force curve ends at so many lengths of the spring


def add(deck: Deck, model: Model) -> None:
    """Add each spring and damper, with its property."""
    for entry in deck.all(ELEMENT_DISCRETE):
        ends = model.nodes.corners(entry, entry.keyword.corners)
        for i, (first, second) in enumerate(ends):
            part = deck.find(PART, pid=int(entry.pid[i]), referred_by=(entry, "pid", i))
            material = deck.find(
                MAT_SPRING_ELASTIC,
                MAT_SPRING_NONLINEAR_ELASTIC,
                MAT_DAMPER_VISCOUS,
                mid=part.mid,
                referred_by=(part, "mid"),
            )
            length, eid, size = model.length(first, second), int(entry.eid[i]), float(entry.s[i])
            if length == 0.0:
                raise entry.error("n2", "calculix: a spring between nodes at one place has no direction", i)
            damper = material.keyword is MAT_DAMPER_VISCOUS
            name = f"{'DAMPER' if damper else 'SPRING'}{eid}"
            model.add(entry.keyword, eid, "DASHPOTA" if damper else "SPRINGA", name, (first, second))
            if damper:
                model.elements += [f"*DASHPOT,ELSET={name}", "", real(size * material.dc)]
                continue
            offset = float(entry.offset[i])
            lines, stiffness = _spring(deck, material, name, size, offset, length)
            model.elements += lines
            model.join(first, second, stiffness)
            model.preloaded |= "NONLINEAR" in lines[0]


def _spring(
    deck: Deck, material: Entry, name: str, size: float, offset: float, length: float
) -> tuple[Lines, float]:
    """The property of a spring, and its largest stiffness."""
    if material.keyword is MAT_SPRING_NONLINEAR_ELASTIC:
        d, f = points(deck.find(DEFINE_CURVE, lcid=material.lcd, referred_by=(material, "lcd")))
        return _curve(name, d - offset, size * f), size * float((np.diff(f) / np.diff(d)).max())
    k = size * material.k
    if offset == 0.0:
        return [f"*SPRING,ELSET={name}", "", real(k)], k
    d = FAR * length * np.array([-1.0, 1.0])
    return _curve(name, d, k * (d + offset)), k


def _curve(name: str, d: np.ndarray, f: np.ndarray) -> Lines:
    return [f"*SPRING,ELSET={name},NONLINEAR", *table(np.column_stack([f, d]).ravel(), 2)]
