"""Who begins in contact deeper than round-off: a defect of the mesh, which the option IGNORE says how to treat."""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.detection import ROUND_OFF, gap, nearest, size
from vmharness.explicit.contact.geometry import at, beyond, corners
from vmharness.explicit.contact.projection import half_thickness, place
from vmharness.explicit.contact.records import Records
from vmharness.explicit.contact.search import candidates, size_of
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import dot, scale
from vmharness.explicit.model.state import Array

Index = NDArray[np.intp]


def penetrations(x: Array, nodes: Records, segments: Records, maxpar: float) -> list[tuple[int, Array]]:
    """Nodes behind the segment that is nearest to them, or within its thickness: (row, way to the surface (3,))."""
    if not segments.size:
        return []
    first, near = candidates(x, nodes, segments, 2.0 * size_of(x, segments))
    ways = ways_out(x, nodes, segments, first, near, maxpar)
    return [(int(nodes["row"][t]), ways[t]) for t in np.flatnonzero(ways.any(axis=1))]


@kernel
def ways_out(x: Array, nodes: Records, segments: Records, first: Index, near: Index, maxpar: float) -> Array:
    """The shortest displacement (nt, 3) that brings each node to the surface; zero where it is not behind."""
    ways = np.zeros((nodes.size, 3))
    for t in range(nodes.size):
        node = nodes[t]
        p = at(x, node["row"])
        s = nearest(x, node, segments, near[first[t] : first[t + 1]])
        if s >= 0:
            segment = segments[s]
            c, half = corners(x, segment["nodes"]), half_thickness(node, segment)
            xi, eta, _, away, n = place(x, segment, p, 0.25, 0.25)
            distance = np.sqrt(dot(away, away))
            if segment["two_sided"]:
                if half - distance > ROUND_OFF * size(c):
                    to = scale(half / distance - 1.0, away) if distance > 0.0 else scale(half, n)
                    ways[t] = to
            else:
                xi, eta, height = gap(segment["triangle"], c, p, xi, eta)
                depth = half - height  # beyond the depth of release it is the far side of the same solid
                if (
                    ROUND_OFF * size(c) < depth <= segment["release"]
                    and beyond(segment["triangle"], xi, eta) <= maxpar - 1.0
                ):
                    ways[t] = scale(depth, n)
    return ways
