"""Beams outside a deck, and what they do under given displacements and rotations."""

from types import SimpleNamespace

import numpy as np
import pytest

from vmharness.explicit.elements.beam.belytschko_schwer import BelytschkoSchwer
from vmharness.explicit.elements.beam.belytschko_schwer.inertia import lumped, stable_step
from vmharness.explicit.elements.beam.belytschko_schwer.stiffness import CrossSection, stiffness
from vmharness.explicit.state import State

E, NU, RHO = 2.1e11, 0.3, 7850.0
RECTANGLE = CrossSection(a=2e-4, iss=6.667e-9, itt=1.6667e-9, j=4.578e-9)  # 20 mm along t, 10 mm along s


def beams(x, nodes, section=RECTANGLE, orientation=(0.0, 0.0, 1.0)):
    """Beams of one section; s lies in the plane of the axis and `orientation`."""
    nodes = np.array(nodes)
    length = np.linalg.norm(x[nodes[:, 1]] - x[nodes[:, 0]], axis=1)
    vectors = np.broadcast_to(np.array(orientation), (len(nodes), 3))
    limit = stable_step(length, section, E, NU, RHO)
    elastic, masses = stiffness(length, section, E, NU), lumped(length, section, RHO)
    return BelytschkoSchwer("beams", nodes, x, vectors, elastic, limit, *masses, section.a)


def at_rest(x):
    n = len(x)
    return State(np.array(x, float), np.zeros((n, 3)), np.zeros((n, 3)), np.ones(n), np.ones(n), dt=1.0)


def internal(block, s, x, rotation):
    """Internal forces and moments (n, 6) once the nodes are at `x` and have turned by `rotation` (n, 3)."""
    s.x[:], s.omega[:] = x, rotation
    s.f[:], s.moment[:] = 0.0, 0.0
    block.add(s)
    return -np.hstack([s.f, s.moment])


def stiffness_matrix(x, nodes, section=RECTANGLE, orientation=(0.0, 0.0, 1.0)):
    """K (6n, 6n) by central differences of 1e-7: x, y, z and rotations of node 1, then of node 2, ..."""
    K = np.zeros((6 * len(x), 6 * len(x)))
    for column in range(K.shape[1]):
        for sign in (1, -1):
            d = np.zeros((len(x), 6))
            d.flat[column] = sign * 1e-7
            f = internal(beams(x, nodes, section, orientation), at_rest(x), x + d[:, :3], d[:, 3:])
            K[:, column] += sign * f.ravel() / 2e-7
    return K


def mass_matrix(x, nodes, section=RECTANGLE):
    """Lumped mass and inertia (6n,)."""
    nodes, total = np.array(nodes), np.zeros((len(x), 6))
    mass, inertia = lumped(np.linalg.norm(x[nodes[:, 1]] - x[nodes[:, 0]], axis=1), section, RHO)
    for end in nodes.T:
        np.add.at(total, end, np.repeat([mass, inertia], 3, axis=0).T)
    return total.ravel()


def line(lengths):
    """Nodes and elements of a straight beam along x."""
    x = np.column_stack([np.concatenate([[0.0], np.cumsum(lengths)]), *np.zeros((2, len(lengths) + 1))])
    return x, np.column_stack([np.arange(len(lengths)), np.arange(1, len(lengths) + 1)])


def rotation(vector):
    """The matrix of a rotation by the vector's length about it."""
    angle = np.linalg.norm(vector)
    k = np.array(vector) / angle
    K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


@pytest.fixture(scope="session")
def bench() -> SimpleNamespace:
    """The functions above, for the tests of this folder."""
    return SimpleNamespace(
        E=E, NU=NU, RHO=RHO, G=E / (2 * (1 + NU)), RECTANGLE=RECTANGLE, section=CrossSection, beams=beams,
        at_rest=at_rest, internal=internal, stiffness_matrix=stiffness_matrix, mass_matrix=mass_matrix, line=line,
        rotation=rotation, stable_step=stable_step, lumped=lumped,
    )  # fmt: skip
