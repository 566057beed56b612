"""The solids of one part, as a force."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.damping.damped_law import damped, memory, solid, unload
from vmharness.explicit.elements.solid._channel import CHANNELS, COMPONENTS, stress_in_space
from vmharness.explicit.elements.solid._gradient import measures
from vmharness.explicit.elements.solid._rows import KEPT, MASS, MODULUS, ROTATION, ROWS, SPEED, VISCOSITY
from vmharness.explicit.elements.solid._stress import compiled_step
from vmharness.explicit.force import copy_of
from vmharness.explicit.kernels.simd import LANES, by_block, by_element
from vmharness.explicit.materials import has_long_curve
from vmharness.explicit.state import Array, Index, State


class Hexahedra:
    """Solids of one part: a force with the energies "internal" and "hourglass".

    `step`: that of the formulation, see one_point/step.py; `law`: kernel of the material, see materials/_law.py, with
    its `constants` and `history` variables per point, `channels`: names of some of these; `nodes (ne, 8)`: rows of the
    state's arrays; `x (n, 3)`: initial coordinates; `density`; `modulus`: rho c^2 of dilatational waves; `points` in an
    element; `viscous`: Q1 and Q2 of bulk viscosity; `resistance (ne,)`: moduli of hourglass control and `hourglass`,
    whether viscous and whether projected. Consistent units.
    """

    kind = "solid"

    def __init__(
        self,
        name: str,
        step: Callable[..., float],
        law: Callable[..., Any],
        nodes: Index,
        x: Array,
        density: float,
        modulus: float,
        constants: tuple[Any, ...],
        points: int = 1,
        viscous: tuple[float, float] = (0.0, 0.0),
        resistance: Array | float = 0.0,
        hourglass: tuple[bool, bool] = (True, True),
        history: int = 0,
        channels: Mapping[str, int] | None = None,
        eid: NDArray[np.int64] | None = None,
        pid: int | None = None,
    ) -> None:
        elements, (volume, _, _) = len(nodes), measures(x[nodes])
        self.nodes, self.mass, self.inertia = nodes, density * volume / 8, np.zeros(elements)
        self.name, self.pid = name, pid
        self.eid = np.arange(1, elements + 1) if eid is None else eid
        self.elements, self.points = elements, points
        self._plain_step, self._law = step, law
        self._step = compiled_step(step, law, has_long_curve(constants))
        self._modulus, self._constants = modulus, constants
        self._viscous, self._hourglass = viscous, hourglass
        self._stable = np.inf
        self._damped = False
        kept = np.zeros((elements, KEPT))
        kept[:, ROTATION] = 1.0
        self._kept = by_block(kept)
        self._nodes = by_block(nodes.astype(np.intp))
        speed = np.broadcast_to((modulus / density) ** 0.5, elements)
        self._fixed = by_block(np.column_stack([8 * self.mass, np.broadcast_to(resistance, elements), speed]))
        self._longest = float(self._overshoot().min())
        self._stress = by_block(np.zeros((elements, points, 6)))
        self._history = by_block(np.zeros((elements, points, history)))
        self._channels = dict(channels or {})
        self._work = np.zeros(ROWS * LANES)
        self._energy = np.zeros(2)
        self.energy = {"internal": self._energy[:1], "hourglass": self._energy[1:]}

    def add(self, state: State) -> None:
        """Add forces at t_n, and the work of the step that led there."""
        self._stable = self._step(
            state.x, state.v, state.dt,
            self._nodes, self.elements, self._fixed,
            self._modulus, self._viscous, self._hourglass, self._constants,
            self._kept, self._stress, self._history,
            state.f, self._energy,
            self._work,
        )  # fmt: skip

    def stable_step(self) -> float:
        """The shortest L_e / (Q + sqrt(Q^2 + c^2)) at the last `add`, or less where hourglass control is strong."""
        return min(self._stable, self._longest)

    def steps(self, x: Array) -> Array:
        """L_e / c (ne,) at coordinates `x` (n, 3), of elements that are not compressed: without bulk viscosity."""
        *_, length = measures(x[self.nodes])
        speed = by_element(self._fixed, self.elements)[:, SPEED]
        return np.asarray(length / speed)

    def scale_density(self, factor: Array) -> None:
        """Raise the densities by `factor` (ne,)."""
        fixed = by_element(self._fixed, self.elements).copy()
        fixed[:, MASS] *= factor
        fixed[:, SPEED] /= np.sqrt(factor)
        if self._hourglass[0]:
            fixed[:, MODULUS] *= np.sqrt(factor)
        self._fixed[:] = by_block(fixed)
        self._longest = float(self._overshoot().min())

    def damp(self, beta: Array) -> None:
        """Add to the stress of the law `beta` (ne,) times its rate; call it before the first step."""
        history = self._history.shape[-1] // LANES
        self._history = by_block(memory(beta, self.points, history, len(COMPONENTS)))
        self._damped = True
        law = damped(solid, self._law, history)
        self._step = compiled_step(self._plain_step, law, has_long_curve(self._constants))

    def linearised(self) -> "Hexahedra":
        """A copy without stress; its linear viscous terms are twice as large.

        Bulk viscosity acts in compression alone, so that forward and back it has half its effect. That is right: in
        the highest mode compression and extension alternate.
        """
        made = copy_of(self)
        made._viscous = 0.0, 2.0 * self._viscous[1]
        made._stress[:] = 0.0
        made._kept[:, VISCOSITY * LANES :] = 0.0  # all but the frame
        unload(made._history, self._damped)
        if self._hourglass[0]:
            made._fixed[:, MODULUS * LANES : (MODULUS + 1) * LANES] *= 2.0
        return made

    def _overshoot(self) -> Array:
        """The longest step (ne,) at which a viscous hourglass force does not reverse the rate: 2 m q / Q."""
        mass, modulus = by_element(self._fixed, self.elements)[:, : MODULUS + 1].T
        limited = (modulus > 0.0) & self._hourglass[0]
        return np.divide(2.0 * mass, modulus, out=np.full_like(mass, np.inf), where=limited)

    @property
    def stress(self) -> Array:
        """Stress (ne, points, 6) in space: xx, yy, zz, xy, yz, zx, without bulk viscosity."""
        kept = by_element(self._kept, self.elements)
        return stress_in_space(by_element(self._stress, self.elements), kept[:, ROTATION : ROTATION + 4])

    @property
    def history(self) -> Array:
        """History variables of the law (ne, points, k)."""
        return by_element(self._history, self.elements)

    def probe(self, element: int, point: int, component: str) -> Callable[[], float]:
        """`xx-stress` in space, `pressure`, `von-mises`, a channel of the law: of an element (its place in `eid`)."""
        known = (*CHANNELS, *self._channels)
        if component not in known:
            raise ValueError(f"no {component!r} of a solid; there are: {', '.join(known)}")
        if not 1 <= point <= self.points:
            raise ValueError(f"no point {point}; the solid has {self.points}")
        block, lane = element // LANES, element % LANES
        if component in self._channels:
            history, place = self._history[block, point - 1], self._channels[component] * LANES + lane
            return lambda: float(history[place])
        value = CHANNELS[component]
        stress = self._stress[block, point - 1, lane::LANES]
        frame = self._kept[block, lane::LANES][ROTATION : ROTATION + 4]
        return lambda: value(stress_in_space(stress, frame))
