"""*CONTACT_NODES_TO_SURFACE: nodes kept on the outer side of segments by a penalty (type 5, one-way, no thickness).

A node behind a segment by the gap g < 0, measured at its closest point r(xi, eta) along the normal n there, is pushed
back, and the segment's nodes take the reaction by their shape functions:

    f = -k g n        f_i = -N_i(xi, eta) f        k = min(k_segment, k_node)
    k_segment = SLSFAC SFSB K A / d       K bulk modulus, A area, d longer diagonal of the shell

`k_node` is the same for the shells at the tracked node, with SFSA; a node with a mass alone sets none. (LS-DYNA theory
manual, penalty method; VM-LSDYNA-SOLVE-061.) Nothing lets go of a node, however deep: PENCHK = 0.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Card, Deck, Entry, Keyword
from vmharness.deck.field import integer, only, real, text
from vmharness.deck.keywords.control_contact import CONTROL_CONTACT
from vmharness.explicit.compiled import kernel
from vmharness.explicit.model import Model
from vmharness.explicit.segment import nearest, normal, shape
from vmharness.explicit.state import Array, State
from vmharness.explicit.surface import nodes_of_surface, penalty_at_nodes, segments_of_surface

Index = NDArray[np.intp]

CONTACT_NODES_TO_SURFACE = Keyword(
    "CONTACT_NODES_TO_SURFACE",
    Card(
        surfa=integer(),
        surfb=integer(),
        surfatyp=integer(0, choices=(2, 3, 4)),
        surfbtyp=integer(0, choices=(0, 2, 3)),
        saboxid=only(0),
        sbboxid=only(0),
        sapr=integer(0),  # output only
        sbpr=integer(0),
    ),
    Card(
        fs=only(0.0), fd=only(0.0), dc=real(0.0), vc=only(0.0), vdc=only(0.0), penchk=only(0), bt=only(0.0),
        dt=only(1e20, zero_is_default=True),
    ),
    Card(
        sfsa=real(1.0, zero_is_default=True, above=0.0),
        sfsb=real(1.0, zero_is_default=True, above=0.0),
        sast=only(0.0), sbst=only(0.0), sfsat=only(1.0, zero_is_default=True), sfsbt=only(1.0, zero_is_default=True),
        fsf=only(1.0, zero_is_default=True), vsf=only(1.0, zero_is_default=True),
    ),
    options={"ID": Card(cid=integer(0), heading=text("", width=70))},
)  # fmt: skip


def build(deck: Deck, model: Model) -> None:
    """Add a force for each such contact of the deck."""
    taken: set[int] = set()
    for order, entry in enumerate(deck.all(CONTACT_NODES_TO_SURFACE), 1):
        number = entry.cid or order
        if number in taken:
            raise entry.error("cid", "another contact has this number; give each its own by _ID")
        taken.add(number)
        model.forces.append(_contact(deck, model, entry, number))


def _contact(deck: Deck, model: Model, entry: Entry, number: int) -> "NodesToSurface":
    control = deck.first(CONTROL_CONTACT)
    slsfac, orien = (control.slsfac, control.orien) if control else (0.1, 1)
    tracked = nodes_of_surface(deck, model, entry, "surfa", entry.surfatyp)
    segments = segments_of_surface(deck, model, entry, "surfb", entry.surfbtyp)
    stiffness = slsfac * entry.sfsb * segments.penalty
    nodal = slsfac * entry.sfsa * penalty_at_nodes(deck, model, entry, "surfa", tracked)
    if orien == 2 or (orien == 1 and entry.surfbtyp != 0):
        face_toward(segments.nodes, model.state.x, tracked)
    contact = NodesToSurface(number, tracked, segments.nodes, stiffness, nodal)
    for node, gap in contact.initial_penetrations(model.state.x):
        raise entry.error(
            "surfa", f"node {model.ids[node]} begins {-gap:.4g} behind the surface; move it to the front"
        )
    return contact


def face_toward(segments: Index, x: Array, tracked: Index) -> None:
    """Turn all segments over, if the tracked nodes lie, on the whole, behind them (ORIEN)."""
    centre = x[segments].mean(axis=1)
    side = np.einsum("ij,ij->", x[tracked].mean(axis=0) - centre, _normals(x[segments]))
    if side < 0.0:
        segments[:] = segments[:, ::-1]


def _normals(corners: Array) -> Array:
    """Area vectors (ns, 3) of the segments with `corners` (ns, 4, 3)."""
    return np.asarray(0.5 * np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]))


class NodesToSurface:
    """Penalty contact of tracked nodes (nt,) with segments (ns, 4), all given as rows of the state's arrays."""

    def __init__(self, number: int, tracked: Index, segments: Index, stiffness: Array, nodal: Array) -> None:
        """`number` is CID, or the contact's place in the deck; `stiffness` (ns,) and `nodal` (nt,) are k."""
        self.number, self.name = number, f"contact {number}"
        self.tracked, self.segments = tracked, segments
        self.stiffness, self.nodal = stiffness, nodal
        self.segment = np.full(tracked.size, -1)  # (nt,) the segment each node is in contact with, or -1
        self.weights = np.zeros((tracked.size, 4))  # (nt, 4) N_i at the contact point
        self.forces = np.zeros((tracked.size, 3))  # (nt, 3) on the tracked nodes
        self.force = np.zeros(3)  # their sum
        self.energy = {"contact": np.zeros(1)}

    def add(self, state: State) -> None:
        """Find who is behind the surface now, push back, and account for the work of the step."""
        penalise(
            state.f, state.x, state.v, state.dt, self.tracked, self.segments, self.stiffness, self.nodal,
            self.segment, self.weights, self.forces, self.force, self.energy["contact"],
        )  # fmt: skip

    def stable_step(self) -> float:
        """A penalty sets no step: it is soft against the elements that it joins."""
        return np.inf

    def initial_penetrations(self, x: Array) -> list[tuple[int, float]]:
        """Tracked nodes that are behind the surface at `x`, by more than round-off, as pairs (row, gap)."""
        point = np.zeros(3)
        behind = []
        for node in self.tracked:
            s = nearest(x, node, self.segments, point)
            if s >= 0 and point[2] < -1e-9 * np.linalg.norm(np.ptp(x[self.segments[s]], axis=0)):
                behind.append((int(node), float(point[2])))
        return behind


@kernel
def penalise(
    f: Array, x: Array, v: Array, dt: float, tracked: Index, segments: Index, stiffness: Array, nodal: Array,
    segment: Index, weights: Array, forces: Array, force: Array, energy: Array,
) -> None:  # fmt: skip
    """Add contact forces at x_n; the work of the step dt, with v_{n-1/2}, is 1/2 (f_{n-1} + f_n) . dx relative."""
    point, relative = np.empty(3), np.empty(3)
    force[:] = 0.0
    for t in range(tracked.size):
        node, s = tracked[t], segment[t]
        if s >= 0:
            relative_velocity(relative, v, node, segments[s], weights[t])
            energy[0] -= 0.5 * dt * dot(forces[t], relative)

        s = nearest(x, node, segments, point)
        if s >= 0 and point[2] < 0.0:
            for i in range(4):
                weights[t, i] = shape(i, point[0], point[1])
            relative_velocity(relative, v, node, segments[s], weights[t])
            # Contact begins by passing through the surface within the step, not behind an edge. At the start dt is
            # zero, and who is behind by round-off is in contact.
            if segment[t] < 0 and dt > 0.0 and -point[2] > 1.01 * dt * np.sqrt(dot(relative, relative)):
                s = -1
        else:
            s = -1

        segment[t] = s
        if s >= 0:
            push(forces[t], x, segments[s], point, min(stiffness[s], nodal[t]))
            energy[0] -= 0.5 * dt * dot(forces[t], relative)
            for j in range(3):
                force[j] += forces[t, j]
                f[node, j] += forces[t, j]
                for i in range(4):
                    f[segments[s, i], j] -= weights[t, i] * forces[t, j]


@kernel
def push(on_node: Array, x: Array, corners: Index, point: Array, k: float) -> None:
    """f = -k g n at `point` = xi, eta, g of the segment."""
    n = normal(x, corners, point[0], point[1])
    for j in range(3):
        on_node[j] = -k * point[2] * n[j]


@kernel
def relative_velocity(relative: Array, v: Array, node: int, corners: Index, weights: Array) -> None:
    """v - sum N_i v_i, the velocity of the node against the point that it touches."""
    for j in range(3):
        relative[j] = v[node, j]
        for i in range(4):
            relative[j] -= weights[i] * v[corners[i], j]


@kernel
def dot(a: Array, b: Array) -> float:
    """a . b in space."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
