"""Linear elasticity, isotropic: Hooke's law between rates of stress and strain in a frame that turns with the element.

Every plane-stress law has the signature of `plane_stress` below, so that a shell is written once for all of them:

    law(constants, dt, dexx, deyy, dexy, deyz, dezx, sxx, syy, sxy, syz, szx, history, at, stride)
        -> sxx, syy, sxy, syz, szx, dezz

It takes one point over one step: strain increments (engineering shear: dexy = 2 depsilon_xy), the stress before, and
returns the stress after and the strain increment dezz through the thickness that keeps s_zz = 0. `constants` is the
tuple that the material makes once. `dt` serves laws that depend on the rate. The k-th history variable of the point is
`history[at + k * stride]`, kept between steps; HISTORY says how many a law needs
for each state of stress that it can do. Every law for solids has the signature of `solid`:

    law(constants, dt, dexx, deyy, dezz, dexy, deyz, dezx, sxx, syy, szz, sxy, syz, szx, history, at, stride)
        -> sxx, syy, szz, sxy, syz, szx

No branch depends on the point's
state if it can be avoided: the law is inlined in a loop over elements, which then vectorises.

A law for uniaxial stress (bars) takes the increment of the axial strain and returns the axial stress:

    law(constants, dt, deps, s, history, at, stride) -> s
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.state import Array

KEYWORD = MAT_ELASTIC
HISTORY = {"plane_stress": 0, "solid": 0, "uniaxial": 0}


def constants(deck: Deck, entry: Entry) -> tuple[float, float]:
    """Young's modulus E and Poisson's ratio; raises DeckError unless -1 < PR < 1/2."""
    if not -1.0 < entry.pr < 0.5:
        raise entry.error("pr", "must lie between -1 and 0.5")
    return entry.e, entry.pr


@inlined
def plane_stress(
    constants: tuple[float, float],
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
    e, nu = constants
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
    constants: tuple[float, float], dt: float, deps: float, s: float, history: Array, at: int, stride: int
) -> float:
    """Axial stress after the increment `deps` of the axial strain: ds = E deps; no history."""
    e, _ = constants
    return s + e * deps


@inlined
def solid(
    constants: tuple[float, float],
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
    e, nu = constants
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
