"""*MAT_PLASTIC_KINEMATIC (003): bilinear, with hardening from kinematic (BETA = 0) to isotropic (BETA = 1).

The slope ETAN of the uniaxial stress-strain curve gives the plastic modulus; BETA is its isotropic part:

    E_p = E ETAN / (E - ETAN),   Y(p) = SIGY + BETA E_p p,   C = (1 - BETA) E_p

Rates: Cowper and Symonds, if SRC and SRP are given, with the rate of the total strain (VP = 0) or of the plastic strain
(VP = 1), both proportional to Y. The kernels are those of _plasticity.
Source: R. D. Krieg, S. W. Key, Implementation of a time dependent plasticity theory into structural computer programs
(1976); Hallquist, LS-DYNA Theory Manual, material model 3.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.plastic_kinematic import MAT_PLASTIC_KINEMATIC
from vmharness.deck.rule import above, among, at_least, between, only, where
from vmharness.deck.support import supports
from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.piecewise_linear import line
from vmharness.explicit.materials._plasticity.plane_stress import plane_stress
from vmharness.explicit.materials._plasticity.rate import cowper_symonds
from vmharness.explicit.materials._plasticity.solid import solid
from vmharness.explicit.materials._plasticity.uniaxial import uniaxial
from vmharness.explicit.materials.elastic import density, moduli

SUPPORTS = (
    supports(
        MAT_PLASTIC_KINEMATIC,
        **{name: above(0.0) for name in ("ro", "e", "sigy")},
        **{name: at_least(0.0) for name in ("etan", "src", "srp")},
        beta=at_least(0.0, idle=where(lambda entry: entry.etan == 0.0, "ETAN = 0: no hardening")),
        pr=between(-1.0, 0.5),
        fs=only(0.0),
        vp=among(0.0, 1.0, alike=where(lambda entry: not entry.src, "acts with SRC and SRP")),
    ),
)

__all__ = [
    "CHANNELS", "HISTORY", "KEYWORD", "constants", "density", "moduli", "plane_stress", "solid", "uniaxial",
]  # fmt: skip


KEYWORD = MAT_PLASTIC_KINEMATIC

HISTORY = {"plane_stress": 6, "solid": 7, "uniaxial": 2}  # p, and the back stress
CHANNELS = {"plastic-strain": 0}


def constants(deck: Deck, entry: Entry) -> Plastic:
    """E, nu, C, Y and the rate's factor; raises DeckError unless ETAN < E and BETA <= 1."""
    E, nu = moduli(deck, entry)
    if entry.etan >= E:
        raise entry.error("etan", f"must be less than E = {E:g}")
    if entry.beta > 1.0:
        raise entry.error("beta", "must lie between 0 (kinematic) and 1 (isotropic)")
    E_p = E * entry.etan / (E - entry.etan)
    return Plastic(
        E,
        nu,
        C=(1.0 - entry.beta) * E_p,
        Y=line(entry.sigy, entry.beta * E_p),
        rate=cowper_symonds(entry, "src", "srp"),
    )
