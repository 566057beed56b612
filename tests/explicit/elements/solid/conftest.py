"""Meshes of solids, and what a block of them does under given velocities."""

from types import SimpleNamespace

import numpy as np
import pytest

from vmharness.explicit.elements.solid import Hexahedra, measures
from vmharness.explicit.elements.solid import full as hexa_full
from vmharness.explicit.elements.solid import one_point as hexa_one_point
from vmharness.explicit.elements.solid.one_point import Hourglass
from vmharness.explicit.materials import Moduli
from vmharness.explicit.materials.elastic import Elastic, solid
from vmharness.explicit.state import Array, State

E, NU, RHO = 2.1e11, 0.3, 7850.0


def boxes(nx: int, ny: int, nz: int, a: float, b: float, c: float) -> tuple[Array, Array]:
    """Nodes and elements of an a x b x c block."""
    x = np.array([
        (i * a / nx, j * b / ny, k * c / nz)
        for i in range(nx + 1)
        for j in range(ny + 1)
        for k in range(nz + 1)
    ])  # fmt: skip
    n = np.arange(len(x)).reshape(nx + 1, ny + 1, nz + 1)
    low = [n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]]
    corners = [corner[..., :-1] for corner in low] + [corner[..., 1:] for corner in low]
    return x, np.stack(corners, axis=-1).reshape(-1, 8)


def solids(
    x: Array,
    nodes: Array,
    elform: int = 1,
    control: Hourglass | None = None,
    e: float = E,
    nu: float = NU,
    rho: float = RHO,
    viscous: tuple[float, float] = (0.0, 0.0),
) -> Hexahedra:
    """Elastic solids; without bulk viscosity unless asked for."""
    modulus = Moduli(e, nu).longitudinal
    options = {"viscous": viscous, "constants": Elastic(e, nu)}
    if elform == 2:
        return Hexahedra("solids", hexa_full.step, solid, nodes, x, rho, modulus, points=8, **options)
    control = control or Hourglass()
    return Hexahedra(
        "solids",
        hexa_one_point.step,
        solid,
        nodes,
        x,
        rho,
        modulus,
        resistance=hexa_one_point.moduli(x[nodes], rho, modulus, control),
        hourglass=(control.viscous, control.projected),
        **options,
    )


def state(x: Array, dt: float = 1.0) -> State:
    """At rest, with time steps of dt."""
    n = len(x)
    return State(x.copy(), np.zeros((n, 3)), np.zeros((n, 3)), np.ones(n), np.ones(n), dt=dt)


def internal_forces(block: Hexahedra, s: State) -> Array:
    """Internal forces: what the nodes feel, reversed."""
    s.f[:] = 0.0
    block.add(s)
    return -s.f


def lumped(x: Array, nodes: Array, rho: float = RHO) -> Array:
    """Mass (n, 1) of the nodes."""
    total = np.zeros((len(x), 1))
    mass, *_ = measures(x[nodes])
    for corner in nodes.T:
        np.add.at(total, corner, rho * mass[:, None] / 8)
    return total


def stiffness(block: Hexahedra, x: Array, free: list[tuple[int, int]]) -> Array:
    """K by unit velocities over one step and back; `free` (node, axis). So small that the geometry stays."""
    s, small = state(x), 1e-10
    K = np.zeros((len(free), len(free)))
    rows = tuple(np.transpose(free))
    for column, place in enumerate(free):
        s.v[place] = small
        K[:, column] = internal_forces(block, s)[rows] / small
        s.v[place] = -small
        internal_forces(block, s)
        s.v[place] = 0.0
    return K


@pytest.fixture(scope="session")
def bench() -> SimpleNamespace:
    """The above."""
    return SimpleNamespace(
        E=E,
        NU=NU,
        RHO=RHO,
        boxes=boxes,
        solids=solids,
        state=state,
        internal_forces=internal_forces,
        lumped=lumped,
        stiffness=stiffness,
    )
