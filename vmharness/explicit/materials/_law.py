"""The contract of a material law, and the laws of this folder by their *MAT_... cards.

Every law has a keyword and its constants, a NamedTuple that is made once for a part and given to each of its kernels.
HISTORY holds the states of stress for which it has a kernel, with the number of history variables of a point in each:

    ContinuumLaw   "plane_stress" (shells), "solid", "uniaxial" (bars); moduli and density
    SpringLaw      "spring" (springs and dampers); bounds of stiffness and damping

A kernel takes one point over one step of length dt. Its strain increments are in a frame that rotates with the element,
so that stress needs no rotation; shear strains are engineering strains, gamma_xy = 2 epsilon_xy. The k-th history
variable of the point is history[at + k * stride]; it is kept between steps. The kernel is inlined in a loop over
elements, which vectorises as long as no branch depends on the state of the point.
"""

from collections.abc import Mapping
from functools import cache
from types import ModuleType
from typing import Any, NamedTuple, Protocol, TypeAlias, cast

from vmharness import plugins
from vmharness.deck import Deck, Entry, Keyword
from vmharness.explicit.state import Array

FOLDER = "vmharness.explicit.materials"

PlaneStressed: TypeAlias = tuple[float, float, float, float, float, float]  # xx, yy, xy, yz, zx; de_zz
Stressed: TypeAlias = tuple[float, float, float, float, float, float]  # xx, yy, zz, xy, yz, zx


class Moduli(NamedTuple):
    """Young's modulus and Poisson's ratio in the unloaded state, for speeds of sound and penalty stiffness."""

    E: float
    nu: float

    @property
    def bulk(self) -> float:
        """K = E / (3 (1 - 2 nu))."""
        return self.E / (3.0 * (1.0 - 2.0 * self.nu))

    @property
    def longitudinal(self) -> float:
        """rho c^2 = E (1 - nu) / ((1 + nu) (1 - 2 nu)) of dilatational waves.

        >>> round(Moduli(1.0, 0.25).longitudinal, 12)
        1.2
        """
        return self.E * (1 - self.nu) / ((1 + self.nu) * (1 - 2 * self.nu))


class PlaneStress(Protocol):
    """Kernel of a law for shells: stress after a strain increment, with s_zz = 0."""

    def __call__(
        self, constants: Any, dt: float, dexx: float, deyy: float, dexy: float, deyz: float, dezx: float,
        sxx: float, syy: float, sxy: float, syz: float, szx: float, history: Array, at: int, stride: int,
    ) -> PlaneStressed:  # fmt: skip
        """The stress, and the strain increment de_zz through the thickness that keeps s_zz = 0."""


class Solid(Protocol):
    """Kernel of a law for solids: stress after a strain increment."""

    def __call__(
        self, constants: Any, dt: float,
        dexx: float, deyy: float, dezz: float, dexy: float, deyz: float, dezx: float,
        sxx: float, syy: float, szz: float, sxy: float, syz: float, szx: float,
        history: Array, at: int, stride: int,
    ) -> Stressed:  # fmt: skip
        """The stress."""


class Uniaxial(Protocol):
    """Kernel of a law for bars: axial stress after an increment of the axial strain."""

    def __call__(
        self, constants: Any, dt: float, deps: float, s: float, history: Array, at: int, stride: int
    ) -> float:
        """The axial stress."""


class Spring(Protocol):
    """Kernel of a law for springs and dampers: force at t_n, tension positive.

    `elongation` is measured from the unloaded state, `rate` is that of the step that led to t_n. For a torsional
    element the elongation is a rotation and the force a moment.
    """

    def __call__(
        self, constants: Any, dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
    ) -> float:
        """The force."""


class Law(Protocol):
    """A module of the folder of materials."""

    KEYWORD: Keyword
    HISTORY: Mapping[str, int]

    def constants(self, deck: Deck, entry: Entry) -> tuple[Any, ...]:
        """The constants of the law, a NamedTuple; raises DeckError for a value that is out of its range."""


class ContinuumLaw(Law, Protocol):
    """A law between strain and stress, with a kernel for each state of stress in HISTORY."""

    CHANNELS: Mapping[str, int]  # history variables that a probe can read, by name; their places

    def moduli(self, deck: Deck, entry: Entry) -> Moduli:
        """E and nu; raises DeckError for a value that is out of its range."""

    def density(self, deck: Deck, entry: Entry) -> float:
        """Mass per volume in the unloaded state."""


class SpringLaw(Law, Protocol):
    """A law between elongation and force."""

    spring: Spring

    def bounds(self, constants: Any) -> tuple[float, float]:
        """The largest stiffness and the largest damping coefficient of the law, for the stable step."""


@cache
def laws() -> dict[Keyword, ModuleType]:
    """The modules of the folder by their cards; raises ContractError, with the file, for one that is incomplete."""
    found = plugins.modules(FOLDER, "KEYWORD", "HISTORY", "constants")
    for module in found:
        own = ("bounds",) if "spring" in module.HISTORY else ("CHANNELS", "moduli", "density")
        plugins.require(module, FOLDER, *own, *module.HISTORY)
    return {module.KEYWORD: module for module in found}


def material_of(deck: Deck, part: Entry) -> Entry:
    """The *MAT_... card of a part; raises DeckError at the part where there is none."""
    return deck.find(*laws(), mid=part.mid, referred_by=(part, "mid"))


def continuum_law(material: Entry) -> ContinuumLaw:
    """The law of a card, for its moduli and density."""
    return cast(ContinuumLaw, laws()[material.keyword])


def law_of(material: Entry, state: str, part: Entry) -> ModuleType:
    """The module of the material's law; raises DeckError at the part if it has no law for this state of stress."""
    module = laws()[material.keyword]
    if state not in module.HISTORY:
        able = ", ".join(f"*{keyword.name}" for keyword, other in laws().items() if state in other.HISTORY)
        kind = state.replace("_", " ")
        raise part.error("mid", f"*{material.keyword.name} has no law for {kind}; these have one: {able}")
    return module
