"""The highest mode of a model: what limits the step of central differences.

Where damping C lags half a step, the step dt is stable while M - dt/2 C - dt^2/4 K is not negative, so that

    A = M^-1/2 (dt^2/4 K + dt/2 C) M^-1/2        theta = largest eigenvalue of A <= 1

The elements themselves give A z: they take one small step from the present geometry, without stress (see
`Elements.linearised`). M has all mass and rotary inertia that moves. Degrees of freedom that a constraint rules are
left out, and the nodes of a rigid body move with it. Joints and walls are left out; they can only lower theta. Contacts
are left out too, but where contact_steps.py gives them.

The Lanczos method finds theta from below (B. N. Parlett, The Symmetric Eigenvalue Problem, chapter 13). It ends when
the residual of its vector shows that an eigenvalue is near.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from vmharness.explicit.constraint import Binding
from vmharness.explicit.force import Force
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index, State

SMALL = 1e-8  # displacement of the step over the shortest distance between nodes of an element; rotation
FEWEST, MOST = 12, 60  # iterations
RESIDUAL = 0.01  # of theta


class Linear(Protocol):
    """What has linear forces in small motions."""

    def linearised(self) -> Force:
        """The forces of small motions alone."""


class Mode(NamedTuple):
    """theta, its part by stiffness, its vector z, and small v and omega (n, 6) of the nodes in the mode."""

    theta: float
    stiff: float
    z: Array
    velocity: Array


class Motions:
    """The free motions of a model by coordinates z of unit mass: degrees of freedom of nodes, then those of bodies."""

    def __init__(self, model: Model) -> None:
        held = np.zeros((model.ids.size, 6), bool)
        for constraint in model.constraints:
            held |= constraint.fixed
        inverse = np.stack([model.inverse_mass, model.inverse_inertia], axis=1).repeat(3, axis=1)
        scale = np.sqrt(np.where(held, 0.0, inverse)).ravel()
        self.free = np.flatnonzero(scale)
        self.scale, self.shape = scale[self.free], held.shape
        self.bodies: list[tuple[Index, Array]] = []
        for constraint in model.constraints:
            if isinstance(constraint, Binding):
                self.bodies += constraint.modes(model.state, held)
        self.size = self.free.size + sum(modes.shape[2] for _, modes in self.bodies)

    def velocity(self, z: Array) -> Array:
        """v and omega (n, 6) of z."""
        u = np.zeros(self.shape)
        u.ravel()[self.free] = self.scale * z[: self.free.size]
        place = self.free.size
        for nodes, modes in self.bodies:
            u[nodes] = modes @ z[place : place + modes.shape[2]]
            place += modes.shape[2]
        return u

    def force(self, f: Array) -> Array:
        """The forces on the coordinates, by forces and moments (n, 6) on the nodes: the transpose of `velocity`."""
        parts = [np.einsum("ij,ijk->k", f[nodes], modes) for nodes, modes in self.bodies]
        return np.concatenate([self.scale * f.ravel()[self.free], *parts])


def highest_mode(model: Model, dt: float, start: Array | None = None, others: Sequence[Linear] = ()) -> Mode:
    """The highest mode with the step `dt`; the iteration begins with the vector `start`, or with a random one.

    `others`, such as active contacts, act besides the elements.
    """
    motions = Motions(model)
    random = np.random.default_rng(0).standard_normal(motions.size)
    if not motions.size:
        return Mode(0.0, 0.0, random, np.zeros(motions.shape))
    if start is not None and start.size == motions.size:
        random = start + 0.01 * np.abs(start).max() * random
    distance = shortest_distance(model)

    def small(z: Array) -> tuple[float, Array]:
        u = motions.velocity(z)
        size = SMALL / (dt * max(np.abs(u[:, :3]).max() / distance, np.abs(u[:, 3:]).max()))
        return size, size * u

    def product(z: Array, dt: float = dt) -> Array:
        size, u = small(z)
        return -0.25 * dt / size * motions.force(response(model, [*model.blocks, *others], u, dt))

    theta, z = lanczos(product, random)
    longer = float(z @ product(z, 2.0 * dt))  # 4 a + 2 b, where theta = a + b has the parts of K and C
    return Mode(theta, 0.5 * longer - theta, z, small(z)[1])


def response(model: Model, blocks: Iterable[Linear], u: Array, dt: float) -> Array:
    """-(K dt + 2 C) u (n, 6): half the difference of the forces and moments after small steps of velocity u and -u."""
    forward, back = (
        _forces(model, [block.linearised() for block in blocks], sign * u, dt) for sign in (1.0, -1.0)
    )
    return 0.5 * (forward - back)


def _forces(model: Model, forces: Iterable[Force], u: Array, dt: float) -> Array:
    s = model.state
    v, omega = np.ascontiguousarray(u[:, :3]), np.ascontiguousarray(u[:, 3:])
    moved = State(s.x + dt * v, v, omega, s.mass, s.inertia, s.t, dt, cycle=1)
    for force in forces:
        force.add(moved)
    return np.hstack([moved.f, moved.moment])


def shortest_distance(model: Model) -> float:
    """The shortest distance between two successive nodes of an element; 1 where no element has a length."""
    shortest = np.inf
    for block in model.blocks:
        x = model.state.x[block.nodes]
        lengths = np.linalg.norm(np.diff(x, axis=1), axis=2)[(block.nodes >= 0).all(axis=1)]
        shortest = min(shortest, lengths[lengths > 0.0].min(initial=np.inf))
    return float(shortest) if np.isfinite(shortest) else 1.0


def lanczos(product: Callable[[Array], Array], start: Array) -> tuple[float, Array]:
    """The largest eigenvalue of a symmetric operator, from below, and its vector of unit length; NaN on overflow.

    >>> values = np.array([1.0, 2.0, 5.0])
    >>> theta, z = lanczos(lambda z: values * z, np.ones(3))
    >>> round(theta, 9), (z**2).round(9).tolist()
    (5.0, [0.0, 0.0, 1.0])
    """
    q = start / np.linalg.norm(start)
    basis = [q]
    diagonal: list[float] = []
    beside: list[float] = []
    while True:
        w = product(basis[-1])
        if not np.isfinite(w).all():
            return np.nan, w
        diagonal.append(float(w @ basis[-1]))
        Q = np.stack(basis)
        for _ in range(2):  # twice is enough: the vectors are then orthogonal to round-off
            w = w - (Q @ w) @ Q
        T = np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1)
        values, vectors = np.linalg.eigh(T)
        theta, s, size = float(values[-1]), vectors[:, -1], float(np.linalg.norm(w))
        residual = size * abs(s[-1])
        done = len(basis) >= min(FEWEST, start.size) and residual <= RESIDUAL * abs(theta)
        if done or len(basis) == min(MOST, start.size) or size <= 1e-12 * abs(values).max():
            return theta, s @ Q
        beside.append(size)
        basis.append(w / size)
