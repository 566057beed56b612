"""Data of the contact mechanics: tracked nodes, segments, and the state of each contact of a node with a segment."""

from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.vector import Vector, inlined
from vmharness.explicit.state import Array, Index

Records: TypeAlias = NDArray[np.void]
Record: TypeAlias = Any  # one of them: fields by name

MAX_CONTACTS = 6  # active contacts a node: corners of blocks that meet in a pile

# Places in the account (6,) of a pass: energies, and the sum of forces on the tracked nodes at FORCE to FORCE + 2.
CONTACT, FRICTION, FORCE, RELEASED = 0, 1, 2, 5


@dataclass(frozen=True)
class Tracked:
    """Tracked nodes (LS-DYNA: SURFA), with stiffness, thickness and area of their own elements."""

    nodes: Index  # (nt,) rows of the state's arrays, each once
    penalty: Array  # (nt,) SLSFAC SFSA times the largest of the node's elements; infinity where it has none
    thickness: Array  # (nt,) of its shells; zero where it has none, and where mid-surfaces touch
    area: Array  # (nt,) its share of the surface, for VC; infinity where it has none
    faces: Index = field(
        default_factory=lambda: np.zeros((0, 4), np.intp)
    )  # (nf, 4) of the nodes' own surface
    first_face: Index | None = (
        None  # (nt + 1,) faces[first_face[t] : first_face[t + 1]] are at node t; None: none are
    )


@dataclass(frozen=True)
class Segments:
    """Segments (LS-DYNA: SURFB): quadrilaterals and triangles whose normal points to the front (right-hand rule)."""

    nodes: Index  # (ns, 4) rows of the state's arrays; a triangle repeats its third node
    penalty: Array  # (ns,) stiffness, SLSFAC SFSB K A/d of a shell or SLSFAC SFSB K A^2/V of a solid
    thickness: Array  # (ns,) of the shell; zero for solids, and where mid-surfaces touch
    release: Array  # (ns,) depth beyond which a node is released; infinity where none is
    two_sided: NDArray[np.bool_]  # (ns,) contact begins on the side that a node comes from; else on the front


NODE = np.dtype(
    [
        ("row", np.intp),  # in the state's arrays
        ("penalty", np.float64),
        ("thickness", np.float64),
        ("area", np.float64),
        ("count", np.intp),  # of active contacts
        ("own_from", np.intp),  # the faces of its own surface
        ("own_to", np.intp),
        ("clearance", np.float64),  # relative motion since the sort before which no new contact can begin
        ("force", np.float64, 3),  # sum over its contacts
        # These four fill one word.
        ("full_cycles", np.int32),  # cycles in which it needed more than MAX_CONTACTS
        ("long_slides", np.uint16),  # times that it crossed MAX_CROSSINGS borders in one step; 65535 at most
        ("released", np.bool_),  # once at least, deeper than the depth of release
        ("settled", np.bool_),  # all of its contacts stayed well within their segments
    ],
    align=True,
)

SEGMENT = np.dtype(
    [
        ("nodes", np.intp, 4),
        ("penalty", np.float64),
        ("thickness", np.float64),
        ("release", np.float64),
        ("two_sided", np.bool_),
        ("triangle", np.bool_),
    ],
    align=True,
)

CONTACT_STATE = np.dtype(
    [
        ("segment", np.intp),
        ("side", np.float64),  # 1 in front of the segment, -1 behind it, as the node came
        ("xi", np.float64),  # of the contact point
        ("eta", np.float64),
        ("normal", np.float64, 3),  # direction of the normal force on the node
        ("gap", np.float64),  # negative
        ("offset", np.float64),  # initial penetration that causes no force
        ("slip", np.float64, 3),  # stretch of the friction spring
        ("shear", np.float64),  # force in it
        ("force", np.float64, 3),  # on the node
    ],
    align=True,
)


@inlined
def vector_of(field: Array) -> Vector:
    """The vector in a field (3,) of a record."""
    return field[0], field[1], field[2]


@inlined
def is_active(states: Records, s: int, count: int) -> bool:
    """Whether one of the first `count` contacts of a node is with segment s."""
    found = False
    for k in range(count):
        found = found or states[k]["segment"] == s
    return found


@inlined
def write(state: Record, s: int, side: float, xi: float, eta: float, n: Vector, gap: float) -> None:
    """Store segment, contact point, normal and gap of a contact at t_n."""
    state["segment"], state["side"], state["xi"], state["eta"], state["gap"] = s, side, xi, eta, gap
    state["normal"][0], state["normal"][1], state["normal"][2] = n


def node_records(tracked: Tracked) -> Records:
    """Tracked nodes as records (nt,)."""
    records = np.zeros(tracked.nodes.size, NODE)
    records["row"] = tracked.nodes
    for name in ("penalty", "thickness", "area"):
        records[name] = getattr(tracked, name)
    if tracked.first_face is not None:
        records["own_from"], records["own_to"] = tracked.first_face[:-1], tracked.first_face[1:]
    return records


def segment_records(segments: Segments) -> Records:
    """Segments as records (ns,)."""
    records = np.zeros(len(segments.nodes), SEGMENT)
    for name in ("nodes", "penalty", "thickness", "release", "two_sided"):
        records[name] = getattr(segments, name)
    records["triangle"] = segments.nodes[:, 2] == segments.nodes[:, 3]
    return records
