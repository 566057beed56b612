"""*DAMPING_GLOBAL and *DAMPING_PART_MASS: damping in proportion to mass.

    f = -D S m v        D = VALDMP or LC(t) (global), SF LC(t) (part)        S = STX ... SRZ, by direction

D = 2 omega is critical for a mode of frequency omega. The force at t_n is that of v_n = v_{n-1/2} + dt/2 a_n, and the
equation of motion is solved for the acceleration:

    a_n = (f_n/m - D S v_{n-1/2}) / (1 + D S dt/2)

With this the order of central differences remains 2, and damping does not limit the step: without other forces
v_{n+1/2} = (1 - D dt/2)/(1 + D dt/2) v_{n-1/2}. (Damping by -D v_{n-1/2} is of order 1 and shortens the stable step.)
Rotations are damped in the same way. Degrees of freedom that a support or a prescribed motion rules are not damped. If
all S are zero they count as ones.
"""

import numpy as np

from vmharness.deck import Deck, DeckError, Entry
from vmharness.deck.keywords.damping import DAMPING_GLOBAL, DAMPING_PART_MASS, FACTORS
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import above, among, at_least, only, where
from vmharness.deck.support import supports
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.curve import Curve, time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.sets import masses_of_parts
from vmharness.explicit.state import Array, Flags, Index, State
from vmharness.mesh.sets import nodes_of_parts

SUPPORTS = (
    supports(
        DAMPING_GLOBAL,
        lcid=at_least(0),
        valdmp=at_least(0.0, idle=where(lambda entry: entry.lcid, "LCID is used instead")),
    ),
    supports(DAMPING_PART_MASS, lcid=above(0), flag=among(0, 1), struc=only(0)),
)

Term = tuple[Index, Array, Curve]  # nodes (m,), S (6,), D(t)


def build(deck: Deck, model: Model) -> None:
    """Add one constraint for all mass damping of the deck, if it has any."""
    overall, by_part = deck.first(DAMPING_GLOBAL), deck.all(DAMPING_PART_MASS)
    if overall is None and not by_part:
        return
    if overall is not None and by_part:
        raise by_part[0].error("pid", "not supported beside *DAMPING_GLOBAL: whether they add is not certain")
    terms = [_global(deck, model, overall)] if overall is not None else _parts(deck, model, by_part)
    free = np.ones((model.ids.size, 6), bool)
    for constraint in model.constraints:
        if isinstance(constraint, PrescribedMotion) and not constraint.throughout(model.end_time):
            raise (overall or by_part[0]).error(
                None, f"not supported with {constraint.name}, which is not throughout"
            )
        free &= ~constraint.fixed
    model.constraints.append(MassDamping(terms, free))


def _global(deck: Deck, model: Model, entry: Entry) -> Term:
    nodes = np.arange(model.ids.size)
    if entry.lcid:
        return nodes, _factors(entry), time_curve(deck, entry, "lcid", model.end_time)
    return nodes, _factors(entry), Curve(np.zeros(1), np.full(1, entry.valdmp))


def _parts(deck: Deck, model: Model, entries: list[Entry]) -> list[Term]:
    """A term for each part; a node that parts share with different damping is an error: its mass is not divided."""
    damped = [_part(deck, model, entry) for entry in entries]
    by_node: dict[int, tuple[object, ...]] = {}
    for entry, (nodes, factors, _) in zip(entries, damped, strict=True):
        own = (entry.lcid, entry.sf, *factors)
        for row in nodes.tolist():
            if by_node.setdefault(row, own) != own:
                raise _shared_node(entry, model, row)
    rest = nodes_of_parts(deck, model, {part.pid for part in deck.all(PART)} - {e.pid for e in entries})
    for entry, (nodes, *_) in zip(entries, damped, strict=True):
        for row in np.intersect1d(nodes, rest):
            raise _shared_node(entry, model, int(row))
    return damped


def _part(deck: Deck, model: Model, entry: Entry) -> Term:
    deck.find(PART, pid=entry.pid, referred_by=(entry, "pid"))
    curve, nodes = time_curve(deck, entry, "lcid", model.end_time), masses_of_parts(deck, model, {entry.pid})
    if not nodes.size:
        raise entry.error("pid", "the part has no elements: there is nothing to damp")
    return nodes, entry.sf * _factors(entry), curve


def _shared_node(entry: Entry, model: Model, row: int) -> DeckError:
    return entry.error(
        "pid", f"node {model.ids[row]} belongs to a part with other damping as well; not supported"
    )


def _factors(entry: Entry) -> Array:
    """S (6,)."""
    factors = np.array([getattr(entry, name) for name in FACTORS])
    return factors if factors.any() else np.ones(6)


class MassDamping:
    """-D S m v at the free degrees of freedom of nodes."""

    name = "mass damping"

    def __init__(self, terms: list[Term], free: Flags) -> None:
        """`terms`: nodes, S (6,) and D(t); `free` (n, 6): what no other constraint rules."""
        self.terms, self.free = terms, free
        self.steady = all(curve.constant for *_, curve in terms)
        self.energy = {"damping": np.zeros(1)}
        self.fixed = np.zeros_like(free)
        self.force = np.zeros(free.shape)  # (n, 6)
        self.rate = np.zeros(free.shape)  # (n, 6) D S
        self._update(0.0)

    def _update(self, t: float) -> None:
        for nodes, factors, curve in self.terms:
            self.rate[nodes] = curve(t) * factors
        self.rate *= self.free

    def accelerate(self, state: State) -> None:
        """Solve for a_n, and add the work of the step that led to t_n."""
        if not self.steady:
            self._update(state.t)
        s, rate, force, energy = state, self.rate, self.force, self.energy["damping"]
        add_damping(s.v, s.a, s.mass, rate[:, :3], force[:, :3], s.dt, energy)
        add_damping(s.omega, s.alpha, s.inertia, rate[:, 3:], force[:, 3:], s.dt, energy)

    def move(self, state: State, dt: float) -> None:
        """Nothing to do: the damping is in the acceleration."""


@kernel
def add_damping(v: Array, a: Array, mass: Array, rate: Array, force: Array, dt: float, energy: Array) -> None:
    """Set a = (a - D v)/(1 + D dt/2), and add the dissipated work, -1/2 (f_n + f_{n+1}) dt v_{n+1/2}, to `energy`."""
    for i in range(mass.size):
        for j in range(3):
            damped = (a[i, j] - rate[i, j] * v[i, j]) / (1.0 + 0.5 * dt * rate[i, j])
            now = mass[i] * (damped - a[i, j])
            energy[0] -= 0.5 * (force[i, j] + now) * dt * v[i, j]
            force[i, j] = now
            a[i, j] = damped
