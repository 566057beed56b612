"""What a contact remembers of each node, of each segment, and of each point where they touch."""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.segments import Segments
from vmharness.explicit.contact.tracked import Tracked
from vmharness.explicit.kernels.vector import Vector, inlined

Records: TypeAlias = NDArray[np.void]
Record: TypeAlias = Any  # one of them: fields by name

MOST = 6  # a node touches at most so many places at once: corners of blocks that meet in a pile

NODE = np.dtype(
    [
        ("row", np.intp),  # in the state's arrays
        ("penalty", np.float64),
        ("thickness", np.float64),
        ("area", np.float64),
        ("count", np.intp),  # of its touches
        (
            "clear",
            np.float64,
        ),  # nothing new is touched before surfaces have moved so far since they were sorted
        ("force", np.float64, 3),  # sum over its touches
        ("released", np.bool_),  # once at least, for its depth
        ("settled", np.bool_),  # all of these have stayed well within their segments
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

TOUCH = np.dtype(
    [
        ("segment", np.intp),
        ("side", np.float64),  # 1 in front of the segment, -1 behind it, as the node came
        ("xi", np.float64),  # of the contact point
        ("eta", np.float64),
        ("normal", np.float64, 3),  # along which the node is pushed
        ("gap", np.float64),  # negative
        ("ease", np.float64),  # penetration that is left as it is
        ("slip", np.float64, 3),  # stretch of the spring that sticks
        ("shear", np.float64),  # force in it
        ("force", np.float64, 3),  # on the node
    ],
    align=True,
)


@inlined
def write(touch: Record, s: int, side: float, xi: float, eta: float, n: Vector, gap: float) -> None:
    """Keep where a touch is found at t_n."""
    touch["segment"], touch["side"], touch["xi"], touch["eta"], touch["gap"] = s, side, xi, eta, gap
    touch["normal"][0], touch["normal"][1], touch["normal"][2] = n


def node_records(tracked: Tracked) -> Records:
    """Tracked nodes as records (nt,)."""
    records = np.zeros(tracked.nodes.size, NODE)
    records["row"] = tracked.nodes
    for name in ("penalty", "thickness", "area"):
        records[name] = getattr(tracked, name)
    return records


def segment_records(segments: Segments) -> Records:
    """Segments as records (ns,)."""
    records = np.zeros(len(segments.nodes), SEGMENT)
    for name in ("nodes", "penalty", "thickness", "release", "two_sided"):
        records[name] = getattr(segments, name)
    records["triangle"] = segments.nodes[:, 2] == segments.nodes[:, 3]
    return records
