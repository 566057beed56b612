"""*MAT_PIECEWISE_LINEAR_PLASTICITY (024): isotropic hardening, the yield stress a curve over the plastic strain.

The curve is the first of these that the card gives; beyond its last point it has its last slope:

    LCSS      *DEFINE_CURVE: yield stress over effective plastic strain
    EPS, ES   up to eight points of the same
    SIGY      Y(p) = SIGY + E ETAN / (E - ETAN) p

The static yield stress is scaled by a curve over the strain rate (LCSR), else after Cowper and Symonds (C, P). With
VP = 1 the rate is that of the plastic strain, and the viscous part is SIGY z, also where LCSS or ES give Y; without
SIGY it is Y z.
The kernels are those of _plasticity. Source: Hallquist, LS-DYNA Theory Manual, material model 24.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.mat.piecewise_linear_plasticity import EPS, ES, MAT_PIECEWISE_LINEAR_PLASTICITY
from vmharness.deck.rule import above, among, at_least, between, only, where
from vmharness.deck.support import supports
from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve, curve, line
from vmharness.explicit.materials._plasticity.plane_stress import plane_stress
from vmharness.explicit.materials._plasticity.rate import Rate, cowper_symonds
from vmharness.explicit.materials._plasticity.solid import solid
from vmharness.explicit.materials._plasticity.uniaxial import uniaxial
from vmharness.explicit.materials.elastic import density, moduli
from vmharness.explicit.state import Array

TABLE = "the yield stress is given by LCSS, or by EPS and ES"


def _given(entry: Entry) -> bool:
    """Whether the yield stress is given by points."""
    return bool(entry.lcss) or any(getattr(entry, name) for name in (*EPS, *ES))


SUPPORTS = (
    supports(
        MAT_PIECEWISE_LINEAR_PLASTICITY,
        ro=above(0.0),
        e=above(0.0),
        pr=between(-1.0, 0.5),
        sigy=at_least(0.0, idle=where(lambda entry: _given(entry) and not (entry.c and entry.vp), TABLE)),
        etan=at_least(0.0, idle=where(lambda entry: _given(entry), TABLE)),
        fail=among(0.0, 1e20, 1e21),
        tdel=only(0.0),
        **{
            name: at_least(0.0, idle=where(lambda entry: entry.lcsr, "LCSR is used instead")) for name in "cp"
        },
        **{name: at_least(0.0) for name in ("lcss", "lcsr")},
        **{
            name: at_least(0.0, idle=where(lambda entry: entry.lcss, "LCSS is used instead"))
            for name in (*EPS, *ES)
        },
        vp=among(0.0, 1.0, alike=where(lambda entry: not (entry.c or entry.lcsr), "acts with C and P")),
        rfiltf=only(0.0),
    ),
)

__all__ = [
    "CHANNELS", "HISTORY", "KEYWORD", "constants", "density", "moduli", "plane_stress", "solid", "uniaxial",
]  # fmt: skip


KEYWORD = MAT_PIECEWISE_LINEAR_PLASTICITY

HISTORY = {"plane_stress": 1, "solid": 1, "uniaxial": 1}
CHANNELS = {"plastic-strain": 0}


def constants(deck: Deck, entry: Entry) -> Plastic:
    """E, nu, no kinematic hardening, Y and the rate's factor; raises DeckError for what is no yield curve."""
    E, nu = moduli(deck, entry)
    if entry.lcss:
        Y = _yield_curve(deck, entry)
    elif _given(entry):
        Y = _pairs(entry)
    else:
        Y = _bilinear(entry, E)
    return Plastic(E, nu, C=None, Y=Y, rate=_rate(deck, entry))


def _bilinear(entry: Entry, E: float) -> Curve:
    if entry.sigy == 0.0:
        raise entry.error("sigy", "a yield stress is required where there is neither LCSS nor EPS and ES")
    if entry.etan >= E:
        raise entry.error("etan", f"must be less than E = {E:g}")
    return line(entry.sigy, E * entry.etan / (E - entry.etan))


def _pairs(entry: Entry) -> Curve:
    """EPS and ES up to the last that is given."""
    eps, es = (np.array([getattr(entry, name) for name in names]) for names in (EPS, ES))
    n = int(np.flatnonzero((eps != 0.0) | (es != 0.0))[-1]) + 1
    if n < 2:
        raise entry.error("eps2", "at least two points are needed")
    if eps[0] != 0.0:
        raise entry.error("eps1", "the first plastic strain must be 0")
    for i in np.flatnonzero(np.diff(eps[:n]) <= 0.0):
        raise entry.error(EPS[i + 1], f"must be greater than {EPS[i].upper()}: plastic strains increase")
    for i in np.flatnonzero(np.diff(es[:n], prepend=0.0) < 0.0):
        raise entry.error(ES[i], f"must not be less than {ES[i - 1].upper()}: softening is not supported")
    if es[0] == 0.0:
        raise entry.error("es1", "must be greater than 0")
    return curve(eps[:n], es[:n])


def _yield_curve(deck: Deck, entry: Entry) -> Curve:
    """The curve LCSS; it must start at no plastic strain and not fall."""
    definition, p, stress = _curve(deck, entry, "lcss")
    if p[0] != 0.0:
        raise definition.error("a1", "the first plastic strain of a yield curve must be 0", 0)
    if stress[0] <= 0.0:
        raise definition.error("o1", "a yield stress must be greater than 0", 0)
    for i in np.flatnonzero(np.diff(stress) < 0.0):
        raise definition.error("o1", "a yield stress must not fall: softening is not supported", int(i) + 1)
    return curve(p, stress)


def _rate(deck: Deck, entry: Entry) -> Rate | None:
    if not entry.lcsr:
        return cowper_symonds(entry, "c", "p", constant=entry.sigy)
    if entry.vp:
        raise entry.error("vp", "the plastic rate is supported with C and P, not with LCSR")
    definition, rate, factor = _curve(deck, entry, "lcsr")
    for i in np.flatnonzero((factor <= 0.0) | (np.diff(factor, prepend=0.0) < 0.0)):
        raise definition.error("o1", "factors of the yield stress must be positive and not fall", int(i))
    return curve(rate, factor), 0.0, 0.0, None


def _curve(deck: Deck, entry: Entry, field: str) -> tuple[Entry, Array, Array]:
    """The *DEFINE_CURVE of a field and its points."""
    definition = deck.find(DEFINE_CURVE, lcid=getattr(entry, field), referred_by=(entry, field))
    x, y = points(definition)
    if x.size < 2:
        raise entry.error(field, "the curve needs at least two points")
    return definition, x, y
