"""The shells of one part, as a force."""

from collections.abc import Callable, Mapping
from math import sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.damping.damped_law import damped, memory, plane_stress, unload
from vmharness.explicit.elements.shell._formulation import Formulation, compiled_lengths, compiled_step
from vmharness.explicit.elements.shell._parts import area
from vmharness.explicit.elements.shell._rows import DENSITY_ROOT, MODULI, ROWS, THICKNESS
from vmharness.explicit.force import copy_of
from vmharness.explicit.kernels.simd import LANES, by_block, by_element
from vmharness.explicit.materials import Moduli, has_long_curve
from vmharness.explicit.state import Array, Index, State

STRESSES = ("xx", "yy", "xy", "yz", "zx")


class Shells:
    """Shells of one part and one formulation: a force with the energies "internal" and "hourglass".

    `nodes (ne, corners)`: rows of the state's arrays; `x (n, 3)`: initial coordinates; `thickness (ne,)`; `law`: kernel
    of the material, see materials/_law.py, with its `constants` and `history` variables per point, `channels`: names of
    some of these; `moduli`: for the stable step; `nip`: Gauss points through the thickness, 1 to 10; `shrf`: shear
    factor kappa; `thinning`: whether the thickness changes with the strain through it; `hourglass_moduli()` (ne, m),
    with `forces` hourglass forces in an element, and whether these are `viscous`. Consistent units.
    Raises ValueError for a shape or an option that the element does not support.
    """

    kind = "shell"

    def __init__(
        self,
        formulation: Formulation,
        name: str,
        nodes: Index,
        x: Array,
        thickness: Array,
        density: float,
        law: Callable[..., Any],
        constants: tuple[Any, ...],
        moduli: Moduli,
        nip: int = 2,
        shrf: float = 1.0,
        isdo: int = 0,
        thinning: bool = False,
        history: int = 0,
        channels: Mapping[str, int] | None = None,
        eid: NDArray[np.int64] | None = None,
        pid: int | None = None,
        hourglass_moduli: Callable[[], Array] | None = None,
        viscous: bool = False,
        forces: int = 0,
    ) -> None:
        _check(formulation, nodes, x, thickness, nip, isdo)
        elements = len(nodes)
        self.nodes = nodes
        self.mass, self.inertia = formulation.nodal_mass(x[nodes], thickness, density, moduli.nu, shrf)

        self.name, self.pid = name, pid
        self.eid = np.arange(1, elements + 1) if eid is None else eid
        self.elements, self.nip = elements, nip
        self._channels = dict(channels or {})
        self._shrf, self._constants = float(shrf), constants
        self._viscous, self._thinning = viscous, thinning
        self._wave_speed = wave_speed(moduli, density, isdo)
        self._length = np.inf
        self._damped = False
        self._points = np.stack(np.polynomial.legendre.leggauss(nip), axis=1)
        self._nodes = by_block(nodes.astype(np.intp))
        unscaled = np.ones(elements)
        resistance = hourglass_moduli() if hourglass_moduli else np.zeros((elements, 0))
        self._section = by_block(np.column_stack([thickness, unscaled, resistance]))
        self._stress = by_block(np.zeros((elements, nip, 5)))
        self._hourglass = by_block(np.zeros((elements, forces)))
        self._history = by_block(np.zeros((elements, nip, history)))
        self._work = np.zeros(ROWS * LANES)
        self._energy = np.zeros(2)
        self.energy = {"internal": self._energy[:1], "hourglass": self._energy[1:]}
        self._formulation, self._law, self._isdo = formulation, law, isdo
        self._step = compiled_step(formulation, law, has_long_curve(constants), isdo)
        self._lengths = compiled_lengths(formulation, isdo)

    def add(self, state: State) -> None:
        """Add forces and moments at t_n, and the work of the step that led there."""
        self._length = self._step(
            state.x, state.v, state.omega, state.dt,
            self._nodes, self.elements, self._section,
            self._points, self._shrf, self._thinning, self._viscous, self._constants,
            self._stress, self._history, self._hourglass,
            state.f, state.moment, self._energy,
            self._work,
        )  # fmt: skip

    def stable_step(self) -> float:
        """The shortest L_s / c at the geometry of the last `add`."""
        return self._length / self._wave_speed

    def steps(self, x: Array) -> Array:
        """L_s / c (ne,) at coordinates `x` (n, 3)."""
        lengths = np.zeros(self.elements)
        self._lengths(x, self._nodes, self._work, lengths)
        return lengths * by_element(self._section, self.elements)[:, DENSITY_ROOT] / self._wave_speed

    def scale_density(self, factor: Array) -> None:
        """Raise the densities by `factor` (ne,)."""
        section = by_element(self._section, self.elements).copy()
        section[:, DENSITY_ROOT] *= np.sqrt(factor)
        self._section[:] = by_block(section)

    def damp(self, beta: Array) -> None:
        """Add to the stress of the law `beta` (ne,) times its rate; call it before the first step."""
        history = self._history.shape[-1] // LANES
        self._history = by_block(memory(beta, self.nip, history, len(STRESSES)))
        self._damped = True
        law = damped(plane_stress, self._law, history)
        self._step = compiled_step(self._formulation, law, has_long_curve(self._constants), self._isdo)

    def linearised(self) -> "Shells":
        """A copy without stress; its viscous terms are twice as large."""
        made = copy_of(self)
        made._stress[:] = made._hourglass[:] = 0.0
        unload(made._history, self._damped)
        if self._viscous:
            made._section[:, MODULI * LANES :] *= 2.0
        return made

    @property
    def stress(self) -> Array:
        """Stress (ne, nip, 5) in the elements' frames, from the lowest point up: xx, yy, xy, yz, zx."""
        return by_element(self._stress, self.elements)

    @stress.setter
    def stress(self, stress: Array) -> None:
        self._stress[:] = by_block(stress)

    def probe(self, element: int, point: int, component: str) -> Callable[[], float]:
        """`xx-stress`, ... of an element (its place in `eid`) in its own frame, at a point counted from the lowest."""
        stresses = {f"{axes}-stress": (self._stress, row) for row, axes in enumerate(STRESSES)}
        known = stresses | {name: (self._history, row) for name, row in self._channels.items()}
        known["thickness"] = (
            np.broadcast_to(self._section[:, None], (len(self._section), self.nip, self._section.shape[1])),
            THICKNESS,
        )
        if component not in known:
            raise ValueError(f"no {component!r} of a shell; there are: {', '.join(known)}")
        if not 1 <= point <= self.nip:
            raise ValueError(f"no point {point}; the shell has {self.nip}")
        table, row = known[component]
        values, place = table[element // LANES, point - 1], row * LANES + element % LANES
        return lambda: values[place]


def wave_speed(moduli: Moduli, density: float, isdo: int) -> float:
    """Speed of sound c that goes with the length of ISDO; consistent units.

        ISDO 0, 1   c = sqrt(E / (rho (1 - nu^2)))        ISDO 2   c = sqrt(E / rho)

    >>> round(wave_speed(Moduli(210.0, 0.3), 7.8e-6, 0), 2)
    5439.28
    """
    E, nu = moduli
    return sqrt(E / density) if isdo == 2 else sqrt(E / (density * (1 - nu * nu)))


def _check(formulation: Formulation, nodes: Index, x: Array, thickness: Array, nip: int, isdo: int) -> None:
    """Raise ValueError for a shape or an option that the element cannot have."""
    if not 1 <= nip <= 10:
        raise ValueError(f"NIP = {nip}: 1 to 10 points through the thickness are supported")
    if isdo not in range(len(formulation.lengths)):
        raise ValueError(f"ISDO = {isdo}: 0, 1 and 2 are supported")
    if not len(nodes):
        raise ValueError("no shells")
    sorted_nodes = np.sort(nodes, axis=1)
    for wrong, what in (
        (np.any(sorted_nodes[:, 1:] == sorted_nodes[:, :-1], axis=1), "has a node twice"),
        (~(area(x[nodes]) > 0), "has no area"),
        (~(thickness > 0), "has no thickness"),
    ):
        if np.any(wrong):
            raise ValueError(f"shell {np.flatnonzero(wrong)[0]} {what}")
