"""Meshes of shells, and what a block of them does under given velocities."""

from types import SimpleNamespace

import numpy as np
import pytest

from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay, Hourglass, nodal_mass
from vmharness.explicit.materials import Moduli
from vmharness.explicit.materials.elastic import Elastic, plane_stress
from vmharness.explicit.state import Array, State

E, NU, RHO = 2.1e11, 0.3, 7850.0


def rectangles(nx: int, ny: int, a: float, b: float) -> tuple[Array, Array]:
    """Nodes and elements of an a x b sheet."""
    x = np.array([(i * a / nx, j * b / ny, 0.0) for i in range(nx + 1) for j in range(ny + 1)])
    n = np.arange((nx + 1) * (ny + 1)).reshape(nx + 1, ny + 1)
    return x, np.stack([n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]], axis=-1).reshape(-1, 4)


def shells(
    x: Array, nodes: Array, t: float, e: float = E, nu: float = NU, rho: float = RHO, **options
) -> BelytschkoTsay:
    """Elastic shells of one thickness."""
    thickness = np.full(len(nodes), t)
    return BelytschkoTsay(
        "shells", nodes, x, thickness, rho, plane_stress, Elastic(e, nu), Moduli(e, nu), **options
    )


def state(x: Array) -> State:
    """At rest, with time steps of 1."""
    n = len(x)
    return State(x.copy(), np.zeros((n, 3)), np.zeros((n, 3)), np.ones(n), np.ones(n), dt=1.0)


def internal_forces(block: BelytschkoTsay, s: State) -> tuple[Array, Array]:
    """Internal forces and moments: what the nodes feel, reversed."""
    s.f[:], s.moment[:] = 0.0, 0.0
    block.add(s)
    return -s.f, -s.moment


def lumped(x: Array, nodes: Array, t: float, rho: float = RHO, nu: float = NU, shrf: float = 1.0) -> Array:
    """Mass and inertia (n, 6) of a sheet's nodes."""
    total = np.zeros((len(x), 6))
    mass, inertia = nodal_mass(x[nodes], np.full(len(nodes), t), rho, nu, shrf)
    for corner in nodes.T:
        np.add.at(total, corner, np.repeat([mass, inertia], 3, axis=0).T)
    return total


def stiffness(block: BelytschkoTsay, x: Array, free: list[tuple[int, int]]) -> Array:
    """K by unit velocities over one step and back; `free` (node, 0..5). So small that the geometry stays."""
    s, small = state(x), 1e-7
    K = np.zeros((len(free), len(free)))
    rows = tuple(np.transpose(free))
    for column, (node, k) in enumerate(free):
        moved = s.v if k < 3 else s.omega
        moved[node, k % 3] = small
        K[:, column] = np.hstack(internal_forces(block, s))[rows] / small
        moved[node, k % 3] = -small
        internal_forces(block, s)
        moved[node, k % 3] = 0.0
    return K


@pytest.fixture(scope="session")
def bench() -> SimpleNamespace:
    """The functions above, for the tests of this folder."""
    return SimpleNamespace(
        hourglass=Hourglass,
        E=E,
        NU=NU,
        RHO=RHO,
        rectangles=rectangles,
        shells=shells,
        state=state,
        internal_forces=internal_forces,
        lumped=lumped,
        stiffness=stiffness,
    )
