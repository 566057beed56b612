"""Belytschko-Schwer beams: those of one part as a force, and from the deck."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.explicit.elements.beam._parts import beam_parts, lengths, orientations
from vmharness.explicit.elements.beam.belytschko_schwer import step
from vmharness.explicit.elements.beam.belytschko_schwer.inertia import lumped, stable_step
from vmharness.explicit.elements.beam.belytschko_schwer.stiffness import CrossSection, stiffness
from vmharness.explicit.force import copy_of
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index, State

# What a probe shows of an end: the resultants there on the cross-section with the outer normal r.
COMPONENTS = ("axial-force", "axial-stress", "s-shear", "t-shear", "s-moment", "t-moment", "torsion")


class BelytschkoSchwer:
    """Beams of one part: a force with the energy "internal".

    `nodes (ne, 2)`: rows of the state's arrays; `x (n, 3)`: initial coordinates; `orientation (ne, 3)`: vectors in
    the r-s plane; `stiffness (ne, 6)`: see stiffness.py; `limit (ne,)`, the stable step at the initial length, `mass`
    and `inertia (ne,)` of each node: see inertia.py; `area`: of the section.
    """

    kind = "beam"

    def __init__(
        self,
        name: str,
        nodes: Index,
        x: Array,
        orientation: Array,
        stiffness: Array,
        limit: Array,
        mass: Array,
        inertia: Array,
        area: float,
        eid: NDArray[np.int64] | None = None,
        pid: int | None = None,
    ) -> None:
        self.name, self.pid = name, pid
        self.eid = np.arange(1, len(nodes) + 1) if eid is None else eid
        self.resultants = np.zeros((len(nodes), 6))
        self.energy = {"internal": np.zeros(1)}
        self.nodes, self.mass, self.inertia = nodes.astype(np.intp), mass, inertia
        self._stiffness, self._area = stiffness, area
        axis = x[nodes[:, 1]] - x[nodes[:, 0]]
        self._length = np.linalg.norm(axis, axis=1)
        self._triads = np.repeat(_s_and_t(axis, orientation)[:, None], 2, axis=1)
        self._limit, self._stable = limit, float(limit.min())
        self._damping: tuple[Array, Array, Array] | None = (
            None  # beta (ne,), see `step.add_damping`, work lost
        )

    def add(self, state: State) -> None:
        """Add forces and moments at t_n; the stored energy is a function of the deformation alone."""
        step.rotate_triads(self._triads, self.nodes, state.omega, state.dt)
        self._stable = step.step(
            state.x, state.dt,
            self.nodes, self._length, self._limit, self._stiffness,
            self._triads, self.resultants, self._damping,
            state.f, state.moment, self.energy["internal"],
        )  # fmt: skip

    def stable_step(self) -> float:
        """The smallest limit of the elements, each reduced as the element is shortened."""
        return self._stable

    def steps(self, x: Array) -> Array:
        """The limit (ne,) of each element at coordinates `x` (n, 3), reduced as the element is shortened."""
        length = np.linalg.norm(x[self.nodes[:, 1]] - x[self.nodes[:, 0]], axis=1)
        return np.asarray(self._limit * np.minimum(length / self._length, 1.0))

    def scale_density(self, factor: Array) -> None:
        """Raise the densities by `factor` (ne,)."""
        self._limit = self._limit * np.sqrt(factor)

    def damp(self, beta: Array) -> None:
        """Add to the resultants `beta` (ne,) times their rate; call it before the first step."""
        self._damping = beta, np.zeros((len(beta), step.KEPT)), np.zeros(1)

    def linearised(self) -> "BelytschkoSchwer":
        """A copy with its present resultants, which are functions of the geometry; its damping is twice as large."""
        made = copy_of(self)
        if made._damping is not None:
            made._damping[0][:] *= 2.0
        return made

    def probe(self, element: int, point: int, component: str) -> Callable[[], float]:
        """Resultants at an end (point 1 or 2) of an element (its place in `eid`): force of the part beyond, toward r.

        Axial force and stress (force / area), tension positive; shear forces along s and t; moments about s and t,
        and torsion about r. They obey d(t-moment)/dr = -s-shear and d(s-moment)/dr = t-shear.
        """
        if component not in COMPONENTS:
            raise ValueError(f"no {component!r} of a beam; there are: {', '.join(COMPONENTS)}")
        if point not in (1, 2):
            raise ValueError(f"no point {point}; a beam has its ends 1 and 2")
        R, L, second = self.resultants[element], float(self._length[element]), point == 2
        area = self._area
        probes: dict[str, Callable[[], float]] = {
            "axial-force": lambda: R[step.FORCE],
            "axial-stress": lambda: R[step.FORCE] / area,
            "s-shear": lambda: -(R[step.T_1] + R[step.T_2]) / L,
            "t-shear": lambda: (R[step.S_1] + R[step.S_2]) / L,
            "s-moment": lambda: R[step.S_2] if second else -R[step.S_1],
            "t-moment": lambda: R[step.T_2] if second else -R[step.T_1],
            "torsion": lambda: R[step.TORQUE],
        }
        return probes[component]


def _s_and_t(axis: Array, orientation: Array) -> Array:
    """Unit vectors s and t (ne, 2, 3): t is normal to the plane of axis and orientation, s = t x r lies in it."""
    t = np.cross(axis, orientation)
    s = np.cross(t, axis)
    return np.stack([a / np.linalg.norm(a, axis=1, keepdims=True) for a in (s, t)], axis=1)


ELFORM = 2


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part; raises DeckError where the material is not elastic."""
    for part in beam_parts(deck, model, ELFORM):
        if part.rigid:
            continue
        if part.material.keyword is not MAT_ELASTIC:
            raise part.part.error("mid", f"resultant beams support *{MAT_ELASTIC.name} only")
        e, nu = part.moduli
        length, density, card = lengths(part, model.x0), part.density, part.section
        section = CrossSection(card.a, card.iss, card.itt, card.j, card.sa)
        mass, inertia = lumped(length, section, density)
        for end in part.nodes.T:
            model.add_mass(end, mass, inertia)
        model.forces.append(
            BelytschkoSchwer(
                name=f"beams of part {part.pid}",
                nodes=part.nodes,
                x=model.x0,
                orientation=orientations(part, model),
                stiffness=stiffness(length, section, e, nu),
                limit=stable_step(length, section, e, nu, density),
                mass=mass,
                inertia=inertia,
                area=card.a,
                eid=part.eid,
                pid=part.pid,
            )
        )
