"""Truss (*SECTION_BEAM ELFORM = 3): a straight bar of constant cross-section with axial force alone.

With d = x_2 - x_1 and L = |d|, the strain increment of a step is the mid-point rule of the logarithmic strain,

    deps = 2 (L_n - L_{n-1}) / (L_n + L_{n-1})        L_n - L_{n-1} = (d_n + d_{n-1}) . dt v_21 / (L_n + L_{n-1})

which is zero, without cancellation, for any rigid rotation however large. The law gives the axial stress s, and

    N = A s,   f_2 = -N d_n / L_n = -f_1,   work = 1/2 (N_{n-1} + N_n) (L_n - L_{n-1})

A keeps its initial value: there is no contraction. An elastic bar therefore has N = E A ln(L/L_0), to the third order
in the increments, and gives back the energy that it takes. Each node has half the mass rho A L_0.

A single free bar of tangent modulus E has omega^2 = 4 E / (rho L L_0), so that its step is sqrt(L L_0) / c with
c = sqrt(E / rho). This is a bound: no mesh of bars has a higher frequency than its stiffest bar alone, as long as the
stress stays small against E.

Source: J. O. Hallquist, LS-DYNA Theory Manual, truss element; there, the step is L / c.
"""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck
from vmharness.explicit.damping.damped_law import damped, memory, uniaxial, unload
from vmharness.explicit.elements.beam._parts import beam_parts, lengths
from vmharness.explicit.force import copy_of
from vmharness.explicit.kernels.compiled import specialise, to_be_bound
from vmharness.explicit.kernels.simd import LANES, by_block, by_element, put, vector
from vmharness.explicit.kernels.vector import add, dot, scale, subtract
from vmharness.explicit.materials import Uniaxial, has_long_curve, law_of, with_law
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index, State

NAME = "truss"

law: Uniaxial = to_be_bound("law")

ELFORM = 3

# Rows of the buffer: x_2 - x_1, v_2 - v_1, force; work of the step, shortest L L_0.
D, V, F = 0, 3, 6
WORK, LENGTH = 9, 10
ROWS = 11


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part of trusses."""
    for part in beam_parts(deck, model, ELFORM):
        if part.rigid:
            continue
        area, length = part.section.a, lengths(part, model.x0)
        module = law_of(part.material, "uniaxial", part.part)
        block = Truss(
            name=f"trusses of part {part.pid}",
            nodes=part.nodes,
            length=length,
            area=area,
            density=part.density,
            modulus=part.moduli.E,
            law=module.uniaxial,
            constants=module.constants(deck, part.material),
            history=module.HISTORY["uniaxial"],
            channels=module.CHANNELS,
            eid=part.eid,
            pid=part.pid,
        )
        model.forces.append(block)
        for end in part.nodes.T:
            model.add_mass(end, block.mass)


class Truss:
    """Trusses of one part: a force with the energy "internal".

    `nodes (ne, 2)`: rows of the state's arrays; `length (ne,)`: initial lengths; `area`: of the cross-section;
    `density`; `modulus`: E, for the stable step; `law`: kernel of the material, see materials/_law.py, with its
    `constants` and `history` variables per bar, `channels`: names of some of these. Consistent units.
    """

    kind = "beam"

    def __init__(
        self,
        name: str,
        nodes: Index,
        length: Array,
        area: float,
        density: float,
        modulus: float,
        law: Callable[..., Any],
        constants: tuple[Any, ...],
        history: int = 0,
        channels: Mapping[str, int] | None = None,
        eid: NDArray[np.int64] | None = None,
        pid: int | None = None,
    ) -> None:
        self.name, self.pid = name, pid
        self.elements = len(nodes)
        self.eid = np.arange(1, self.elements + 1) if eid is None else eid
        self.nodes, self.mass, self.inertia = nodes, 0.5 * density * area * length, np.zeros(self.elements)
        self._area, self._wave_speed, self._constants = area, (modulus / density) ** 0.5, constants
        self._channels = dict(channels or {})
        self._nodes = by_block(nodes.astype(np.intp))
        self._length = by_block(length[:, None])
        self._stress = by_block(np.zeros((self.elements, 1)))
        self._history = by_block(np.zeros((self.elements, history)))
        self._work = np.zeros(ROWS * LANES)
        self._shortest = np.inf
        self._damped = False
        self.energy = {"internal": np.zeros(1)}
        self._law, self._step = law, _compiled(law, has_long_curve(constants))

    def add(self, state: State) -> None:
        """Add forces at t_n, and the work of the step that led there."""
        self._shortest = self._step(
            state.x, state.v, state.dt,
            self._nodes, self.elements, self._area, self._length,
            self._constants,
            self._stress, self._history,
            state.f, self.energy["internal"],
            self._work,
        )  # fmt: skip

    def stable_step(self) -> float:
        """The smallest sqrt(L L_0) / c at the geometry of the last `add`."""
        return float(self._shortest**0.5 / self._wave_speed)

    def steps(self, x: Array) -> Array:
        """sqrt(L L_0) / c (ne,) at coordinates `x` (n, 3)."""
        now = np.linalg.norm(x[self.nodes[:, 1]] - x[self.nodes[:, 0]], axis=1)
        return np.asarray(np.sqrt(now * by_element(self._length, self.elements)[:, 0]) / self._wave_speed)

    def scale_density(self, factor: Array) -> None:
        """Raise the densities by `factor` (ne,): slower waves have the effect of a longer initial length."""
        self._length[:] = by_block(by_element(self._length, self.elements) * factor[:, None])

    def damp(self, beta: Array) -> None:
        """Add to the stress of the law `beta` (ne,) times its rate; call it before the first step."""
        history = self._history.shape[-1] // LANES
        self._history = by_block(memory(beta, 1, history, 1)[:, 0])
        self._damped = True
        self._step = _compiled(damped(uniaxial, self._law, history), has_long_curve(self._constants))

    def linearised(self) -> "Truss":
        """A copy without stress; its damping is twice as large."""
        made = copy_of(self)
        made._stress[:] = 0.0
        unload(made._history, self._damped)
        return made

    def probe(self, element: int, point: int, component: str) -> Callable[[], float]:
        """`axial-stress`, `axial-force` (tension positive) or a channel of the law; `element`: its place in `eid`."""
        known = {"axial-stress": (1.0, self._stress, 0), "axial-force": (self._area, self._stress, 0)}
        known |= {name: (1.0, self._history, row) for name, row in self._channels.items()}
        if component not in known:
            raise ValueError(f"no {component!r} of a truss; there are: {', '.join(known)}")
        if point != 1:
            raise ValueError(f"no point {point}; a truss has 1")
        factor, table, row = known[component]
        block, place = table[element // LANES], row * LANES + element % LANES
        return lambda: factor * block[place]


@cache
def _compiled(law: Callable[..., Any], long_curve: bool) -> Callable[..., float]:
    return specialise(step, stretch=with_law(stretch, law, long_curve))


def stretch(
    work: Array,
    dt: float,
    area: float,
    length: Array,
    constants: Any,
    stress: Array,
    history: Array,
) -> None:
    """Stress at t_n, force on node 1, and work of the step, for a block of bars."""
    for e in range(LANES):
        d, dx = vector(work, D, e), scale(dt, vector(work, V, e))
        before = subtract(d, dx)
        now = dot(d, d) ** 0.5
        double = now + dot(before, before) ** 0.5
        elongation = dot(add(d, before), dx) / double
        past = stress[e]
        s = law(constants, dt, 2 * elongation / double, past, history, e, LANES)

        stress[e] = s
        put(work, F, e, scale(area * s / now, d))
        work[WORK * LANES + e] = 0.5 * area * (past + s) * elongation
        work[LENGTH * LANES + e] = min(work[LENGTH * LANES + e], now * length[e])


def step(
    # state
    x: Array,
    v: Array,
    dt: float,
    # elements
    nodes: Index,
    elements: int,
    area: float,
    length: Array,
    # material
    constants: Any,
    # elements, in and out
    stress: Array,
    history: Array,
    # out
    f: Array,
    energy: Array,
    # buffer
    work: Array,
) -> float:
    """Bring stresses to t_n, add forces and the work of the step; return the smallest L L_0.

    `x`, `v`, `f` (n, 3); `energy` (1,); per block of LANES bars: `nodes (blocks, 2 rows)`, `length` (L_0 times the
    factor of density), `stress` and `history`.
    """
    for e in range(LANES):
        work[LENGTH * LANES + e] = np.inf
    for block in range(len(nodes)):
        ends = nodes[block]
        for e in range(LANES):
            i, j = ends[e], ends[LANES + e]
            for k in range(3):
                work[(D + k) * LANES + e] = x[j, k] - x[i, k]
                work[(V + k) * LANES + e] = v[j, k] - v[i, k]
        stretch(work, dt, area, length[block], constants, stress[block], history[block])
        for e in range(min(LANES, elements - block * LANES)):
            i, j = ends[e], ends[LANES + e]
            for k in range(3):
                f[i, k] += work[(F + k) * LANES + e]
                f[j, k] -= work[(F + k) * LANES + e]
            energy[0] += work[WORK * LANES + e]
    smallest = np.inf
    for e in range(LANES):
        smallest = min(smallest, work[LENGTH * LANES + e])
    return smallest
