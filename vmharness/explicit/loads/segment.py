"""*LOAD_SEGMENT and *LOAD_SEGMENT_SET: pressure on faces, against their normal (right-hand rule of n1 to n4).

    f_i = -p int N_i n dA        p = SF LC(t - AT) from t = AT on, else 0

over the bilinear face in its position at t_n. With x = sum N_i x_i, N_i = 1/4 (1 + xi_i xi)(1 + eta_i eta), the area
vector dx/dxi x dx/deta = G + H xi + K eta is linear, and the integral is

    int N_i n dA = G + (xi_i H + eta_i K)/3
    G = A x C,  H = A x B,  K = B x C
    A = 1/4 sum xi_i x_i,  B = 1/4 sum xi_i eta_i x_i,  C = 1/4 sum eta_i x_i

A triangle repeats its third node: each of the three nodes has a third of its area vector.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.load.segment import CORNERS, LOAD_SEGMENT, LOAD_SEGMENT_SET
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.rule import above, at_least, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import Vector, add, cross, row, scale, subtract
from vmharness.explicit.model.curve import Curve, time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index, State

PRESSURE = {"lcid": above(0), "at": at_least(0.0)}

SUPPORTS = (
    supports(LOAD_SEGMENT, **PRESSURE, n5=only(0), n6=only(0), n7=only(0), n8=only(0)),
    supports(LOAD_SEGMENT_SET, **PRESSURE),
)

NAME = "pressure on segments"


def build(deck: Deck, model: Model) -> None:
    """Add a force for each curve and arrival time."""
    loads: dict[tuple[int, float], list[tuple[Entry, Index]]] = {}
    for entry in deck.all(LOAD_SEGMENT):
        faces = np.array([[model.row(entry, name, getattr(entry, name)) for name in CORNERS]], np.intp)
        loads.setdefault((entry.lcid, entry.at), []).append((entry, faces))
    for entry in deck.all(LOAD_SEGMENT_SET):
        found = deck.find(SET_SEGMENT, sid=entry.ssid, referred_by=(entry, "ssid"))
        faces = model.corners(found, CORNERS)
        loads.setdefault((entry.lcid, entry.at), []).append((entry, faces))
    for (lcid, at), group in loads.items():
        curve = time_curve(deck, group[0][0], "lcid", model.end_time - at)
        faces = np.concatenate([faces for _, faces in group])
        factor = np.concatenate([np.full(len(faces), entry.sf) for entry, faces in group])
        model.forces.append(Pressure(f"pressure of curve {lcid}", faces, factor, curve, at))


class Pressure:
    """p = factor LC(t - at) on faces (ns, 4), all under one curve."""

    def __init__(self, name: str, faces: Index, factor: Array, curve: Curve, at: float) -> None:
        self.name, self.faces, self.factor, self.curve, self.at = name, faces, factor, curve, at
        self.forces = np.zeros((len(faces), 4, 3))
        self.energy = {"external work": np.zeros(1)}

    def add(self, state: State) -> None:
        """f_i += f_i(p_n, x_n), and the work 1/2 (f_n + f_{n+1}) dt v_{n+1/2}."""
        p = self.curve(state.t - self.at) if state.t >= self.at else 0.0
        add_pressure(
            state.f, state.x, state.v, state.dt, self.faces, self.factor, p, self.forces,
            self.energy["external work"],
        )  # fmt: skip


@kernel
def add_pressure(
    f: Array, x: Array, v: Array, dt: float, faces: Index, factor: Array, p: float, forces: Array, work: Array
) -> None:
    """Add the forces of all faces and their work, and keep them in `forces` for the work of the next step."""
    for s in range(len(faces)):
        shares = nodal_areas(
            row(x, faces[s, 0]), row(x, faces[s, 1]), row(x, faces[s, 2]), row(x, faces[s, 3])
        )
        for i in range(4):
            node = faces[s, i]
            for j in range(3):
                now = -factor[s] * p * shares[i][j]
                work[0] += 0.5 * dt * (forces[s, i, j] + now) * v[node, j]
                f[node, j] += now
                forces[s, i, j] = now


@kernel
def nodal_areas(x1: Vector, x2: Vector, x3: Vector, x4: Vector) -> tuple[Vector, Vector, Vector, Vector]:
    """The nodal area vectors int N_i n dA of the four corners.

    >>> nodal_areas((0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 2.0, 0.0), (0.0, 2.0, 0.0))[0]
    (0.0, 0.0, 1.0)
    """
    p, q = subtract(x3, x1), subtract(x2, x4)  # along the diagonals
    A, C = scale(0.25, add(p, q)), scale(0.25, subtract(p, q))
    B = scale(0.25, subtract(add(x1, x3), add(x2, x4)))
    G, H, K = cross(A, C), scale(1.0 / 3.0, cross(A, B)), scale(1.0 / 3.0, cross(B, C))
    return add(G, scale(-1.0, add(H, K))), add(G, subtract(H, K)), add(G, add(H, K)), add(G, subtract(K, H))
