"""Nodes and segments without a deck: a surface as arrays, and a march in time that needs no elements."""

from collections.abc import Callable, Iterator
from types import SimpleNamespace

import numpy as np
import pytest

from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.parameters import Options
from vmharness.explicit.contact.records import Segments, Tracked
from vmharness.explicit.contact.surface.faces import faces_at
from vmharness.explicit.state import Array, State


class Scene:
    """Nodes that are added piece by piece; those without mass are held."""

    def __init__(self) -> None:
        self.x, self.v, self.mass = [], [], []

    def nodes(self, x, v=(0.0, 0.0, 0.0), mass=1.0) -> Array:
        """Rows (n,) of new nodes."""
        x = np.atleast_2d(np.asarray(x, float))
        first = len(self.x)
        self.x.extend(x)
        self.v.extend(np.broadcast_to(np.asarray(v, float), x.shape))
        self.mass.extend(np.broadcast_to(mass, len(x)).astype(float))
        return np.arange(first, len(self.x))

    def sheet(self, shape: Callable[..., tuple], xs, ys, **motion) -> Array:
        """Quadrilaterals (ns, 4) over a grid, their normal along d/dx x d/dy."""
        grid = np.array([shape(a, b) for b in ys for a in xs])
        rows = self.nodes(grid, **motion).reshape(len(ys), len(xs))
        corners = (rows[:-1, :-1], rows[:-1, 1:], rows[1:, 1:], rows[1:, :-1])
        return np.stack([corner.ravel() for corner in corners], axis=1)

    def state(self) -> State:
        x, mass = np.array(self.x), np.array(self.mass)
        return State(x, np.array(self.v), np.zeros_like(x), mass, np.zeros_like(mass))


@pytest.fixture
def scene() -> Scene:
    return Scene()


def flat(a, b):
    """A plane at z = 0."""
    return a, b, 0.0


def segments(nodes, penalty=1000.0, thickness=0.0, release=np.inf, two_sided=False) -> Segments:
    full = [np.full(len(nodes), value) for value in (penalty, thickness, release, two_sided)]
    return Segments(np.ascontiguousarray(nodes), *full)


def tracked(nodes, penalty=np.inf, thickness=0.0, area=np.inf, faces=None) -> Tracked:
    """Tracked nodes; `faces` (nf, 4) are of their own surface, one-sided."""
    nodes = np.atleast_1d(nodes)
    full = [np.full(nodes.size, value) for value in (penalty, thickness, area)]
    return Tracked(nodes, *full, *(faces_at(faces, nodes) if faces is not None else ()))


def contact(*passes, **options) -> Contact:
    return Contact(1, passes, Options(**options))


def march(
    state: State, forces: list, dt: float, steps: int, gravity=(0.0, 0.0, 0.0), after: Callable | None = None
) -> Iterator[State]:
    """Central differences as in the time loop; nodes without mass keep their velocity; `after` may change it."""
    inverse = np.divide(1.0, state.mass, out=np.zeros_like(state.mass), where=state.mass > 0.0)[:, None]
    for cycle in range(steps + 1):
        state.f[:] = 0.0
        for force in forces:
            force.add(state)
        state.a[:] = state.f * inverse + np.asarray(gravity) * (inverse > 0.0)
        yield state
        if cycle < steps:
            state.v += 0.5 * (state.dt + dt) * state.a
            if after:
                after(state)
            state.x += dt * state.v
            state.t, state.dt, state.cycle = state.t + dt, dt, cycle + 1


def velocity(state: State) -> Array:
    """v_n = v_{n-1/2} + dt/2 a_n."""
    return state.v + 0.5 * state.dt * state.a


def kinetic(state: State) -> float:
    return float(0.5 * (state.mass[:, None] * velocity(state) ** 2).sum())


@pytest.fixture
def bench() -> SimpleNamespace:
    """What tests of contact are made of."""
    parts = (flat, segments, tracked, contact, march, velocity, kinetic)
    return SimpleNamespace(**{part.__name__: part for part in parts})
