"""*MAT_ELASTIC (001): linear isotropic elasticity, Hooke's law between the rates of stress and strain."""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.rule import above, between, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._law import Moduli
from vmharness.explicit.state import Array

KEYWORD = MAT_ELASTIC
HISTORY = {"plane_stress": 0, "solid": 0, "uniaxial": 0}
CHANNELS: dict[str, int] = {}

SUPPORTS = (
    supports(MAT_ELASTIC, ro=above(0.0), e=above(0.0), pr=between(-1.0, 0.5), da=only(0.0), db=only(0.0)),
)


class Elastic(NamedTuple):
    """Young's modulus and Poisson's ratio."""

    E: float
    nu: float


def moduli(deck: Deck, entry: Entry) -> Moduli:
    """E and PR of the card; raises DeckError unless -1 < PR < 1/2."""
    if not -1.0 < entry.pr < 0.5:
        raise entry.error("pr", "must lie between -1 and 0.5")
    return Moduli(entry.e, entry.pr)


def density(deck: Deck, entry: Entry) -> float:
    """RO of the card."""
    return float(entry.ro)


def constants(deck: Deck, entry: Entry) -> Elastic:
    """E and nu; raises DeckError unless -1 < PR < 1/2."""
    return Elastic(*moduli(deck, entry))


@inlined
def plane_stress(
    constants: Elastic,
    dt: float,
    dexx: float,
    deyy: float,
    dexy: float,
    deyz: float,
    dezx: float,
    sxx: float,
    syy: float,
    sxy: float,
    syz: float,
    szx: float,
    history: Array,
    at: int,
    stride: int,
) -> tuple[float, float, float, float, float, float]:
    """Stress after a strain increment, with s_zz = 0; no history.

    ds_xx = E/(1-nu^2) (de_xx + nu de_yy),  ds_xy = G de_xy,  G = E/(2(1+nu)),  de_zz = -nu/(1-nu) (de_xx + de_yy)
    """
    e, nu = constants.E, constants.nu
    plate = e / (1 - nu * nu)
    g = e / (2 * (1 + nu))
    return (
        sxx + plate * (dexx + nu * deyy),
        syy + plate * (deyy + nu * dexx),
        sxy + g * dexy,
        syz + g * deyz,
        szx + g * dezx,
        -nu / (1 - nu) * (dexx + deyy),
    )


@inlined
def uniaxial(
    constants: Elastic, dt: float, deps: float, s: float, history: Array, at: int, stride: int
) -> float:
    """Axial stress after the increment `deps` of the axial strain: ds = E deps; no history."""
    return s + constants.E * deps


@inlined
def solid(
    constants: Elastic,
    dt: float,
    dexx: float,
    deyy: float,
    dezz: float,
    dexy: float,
    deyz: float,
    dezx: float,
    sxx: float,
    syy: float,
    szz: float,
    sxy: float,
    syz: float,
    szx: float,
    history: Array,
    at: int,
    stride: int,
) -> tuple[float, float, float, float, float, float]:
    """Stress after a strain increment; no history.

    ds_xx = lambda (de_xx + de_yy + de_zz) + 2 G de_xx,  ds_xy = G de_xy,  lambda = E nu / ((1+nu)(1-2nu))
    """
    e, nu = constants.E, constants.nu
    g = e / (2 * (1 + nu))
    pressure = 2 * g * nu / (1 - 2 * nu) * (dexx + deyy + dezz)
    return (
        sxx + pressure + 2 * g * dexx,
        syy + pressure + 2 * g * deyy,
        szz + pressure + 2 * g * dezz,
        sxy + g * dexy,
        syz + g * deyz,
        szx + g * dezx,
    )
