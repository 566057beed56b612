"""*ELEMENT_DISCRETE as corotational trusses of unit area: the force acts along the line between the nodes, as there.

A truss has the strain d/L0 for the elongation d, so a law f(d) becomes the stress f(L0 eps): moduli are those of the
spring times L0. An initial elongation OFFSET becomes an initial strain.
"""

from collections.abc import Callable

import numpy as np

from vmharness.backends._translation import springs
from vmharness.backends.opensees.model import Command, Model
from vmharness.deck import Deck, Entry, Keyword
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.keywords.mat.spring_elastic import MAT_SPRING_ELASTIC
from vmharness.deck.keywords.mat.spring_elastoplastic import MAT_SPRING_ELASTOPLASTIC
from vmharness.deck.keywords.mat.spring_nonlinear_elastic import MAT_SPRING_NONLINEAR_ELASTIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import only
from vmharness.deck.support import supports

Law = tuple[Command, float]  # a uniaxial material, and the largest stiffness of the spring

SUPPORTS = (
    *springs.SUPPORTS,
    supports(MAT_SPRING_ELASTOPLASTIC),
    supports(MAT_SPRING_NONLINEAR_ELASTIC, lcr=only(0)),
)


def add(deck: Deck, model: Model) -> None:
    """Add a truss and its material for each spring and damper."""
    for table in deck.all(ELEMENT_DISCRETE):
        rows = model.nodes.corners(table, table.keyword.corners)
        for i, (first, second) in enumerate(rows):
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            length = model.length(first, second)
            if length == 0.0:
                raise table.error("n2", "opensees: a spring between nodes at one place has no direction", i)
            tag, stiffness = _material(deck, model, part, length, float(table.s[i]), float(table.offset[i]))
            model.join(first, second, stiffness)
            ends = model.id(first), model.id(second)
            model.elements.append(["element", "corotTruss", int(table.eid[i]), *ends, 1.0, tag])


def _material(
    deck: Deck, model: Model, part: Entry, length: float, size: float, offset: float
) -> tuple[int, float]:
    """The tag of the uniaxial material of a spring, with an initial strain where there is an offset; its stiffness."""
    material = deck.find(*LAWS, mid=part.mid, referred_by=(part, "mid"))
    tag = model.next()
    command, stiffness = LAWS[material.keyword](deck, material, tag, length, size)
    model.materials.append(command)
    if offset:
        inner, tag = tag, model.next()
        model.materials.append(["uniaxialMaterial", "InitStrainMaterial", tag, inner, offset / length])
    return tag, stiffness


def _elastic(deck: Deck, entry: Entry, tag: int, length: float, size: float) -> Law:
    return ["uniaxialMaterial", "Elastic", tag, size * entry.k * length], size * entry.k


def _viscous(deck: Deck, entry: Entry, tag: int, length: float, size: float) -> Law:
    return ["uniaxialMaterial", "Viscous", tag, size * entry.dc * length, 1.0], 0.0


def _elastoplastic(deck: Deck, entry: Entry, tag: int, length: float, size: float) -> Law:
    """K, FY and isotropic hardening: H = K KT/(K - KT)."""
    hardening = entry.k * entry.kt / (entry.k - entry.kt)
    moduli = [size * entry.k * length, size * entry.fy, size * hardening * length, 0.0]
    return ["uniaxialMaterial", "Hardening", tag, *moduli], size * entry.k


def _nonlinear(deck: Deck, entry: Entry, tag: int, length: float, size: float) -> Law:
    d, f = points(deck.find(DEFINE_CURVE, lcid=entry.lcd, referred_by=(entry, "lcd")))
    strain, stress = (d / length).tolist(), (size * f).tolist()
    law = ["uniaxialMaterial", "ElasticMultiLinear", tag, "-strain", *strain, "-stress", *stress]
    return law, size * float((np.diff(f) / np.diff(d)).max())


LAWS: dict[Keyword, Callable[[Deck, Entry, int, float, float], Law]] = {
    MAT_SPRING_ELASTIC: _elastic,
    MAT_DAMPER_VISCOUS: _viscous,
    MAT_SPRING_ELASTOPLASTIC: _elastoplastic,
    MAT_SPRING_NONLINEAR_ELASTIC: _nonlinear,
}
