"""Initial penetrations: tracked nodes that begin behind the surface by more than round-off, a defect of the mesh.

IGNORE = 0    a contact that is not automatic is refused; an automatic one moves the nodes to the surface, before
              the run and without strain, but not those of a rigid part
IGNORE = 1,2  the node stays, and its penetration is an offset of the gap
"""

from collections.abc import Sequence

import numpy as np

from vmharness.deck import Entry
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.detection import ROUND_OFF
from vmharness.explicit.contact.geometry import at, beyond, corners, size
from vmharness.explicit.contact.projection import half_thickness, height_over, project_node
from vmharness.explicit.contact.records import Records, Tracked
from vmharness.explicit.contact.search import find_candidates, mean_size, nearest_segment
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import dot, scale
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index


def treat_initial_penetrations(
    contact: Contact,
    passes: Sequence[Tracked],
    model: Model,
    entry: Entry,
    kept: bool,
    automatic: bool,
    rigid: Index,
) -> None:
    """Reject, move or keep initially penetrating nodes, as IGNORE says; record it in `model.facts`.

    `rigid`: rows of nodes of rigid parts.
    """
    found = initial_penetrations(contact, model.state.x)
    if not found:
        return
    depths = [float(np.linalg.norm(way)) for _, way in found]
    node, depth = model.ids[found[int(np.argmax(depths))][0]], max(depths)
    if not (kept or automatic):
        raise entry.error("surfa", f"node {node} begins {depth:.4g} behind the surface; move it to the front")
    what = "kept as offsets of the gap (IGNORE)" if kept else "moved to the surface"
    count = f"{len(found)} node{'s' if len(found) > 1 else ''}"
    model.facts[f"Initial penetrations of {contact.name}"] = (
        f"{count}, the deepest {node} by {depth:.4g}: {what}"
    )
    if kept:
        return
    for row, _ in found:
        if row in rigid:
            what = f"node {model.ids[row]} of a rigid part begins behind the surface; move the part, or set IGNORE = 1"
            raise entry.error("surfa", what)
    for tracked in passes:  # the second side of a two-way contact sees where the first has been moved
        for row, way in initial_penetrations(contact, model.state.x):
            if row in tracked.nodes:
                model.state.x[row] += way
                model.x0[row] = model.state.x[row]


def initial_penetrations(contact: Contact, x: Array) -> list[tuple[int, Array]]:
    """Find the nodes that are deeper than round-off: (row, the displacement (3,) that brings it to the surface)."""
    found = []
    for one in contact.passes:
        if one.segments.size:
            first, near = find_candidates(x, one.nodes, one.segments, 2.0 * mean_size(x, one.segments))
            ways = ways_out(one.segments, first, near, contact.options.maxpar, x, one.nodes)
            found += [(int(one.nodes["row"][t]), ways[t]) for t in np.flatnonzero(ways.any(axis=1))]
    return found


@kernel
def ways_out(
    segments: Records, candidate_first: Index, candidates: Index, maxpar: float, x: Array, nodes: Records
) -> Array:
    """The displacement (nt, 3) that brings each node to its nearest segment, or out of its thickness; zero if none."""
    ways = np.zeros((nodes.size, 3))
    for t in range(nodes.size):
        node = nodes[t]
        p = at(x, node["row"])
        s = nearest_segment(segments, candidates[candidate_first[t] : candidate_first[t + 1]], x, node)
        if s >= 0:
            segment = segments[s]
            c, half = corners(x, segment["nodes"]), half_thickness(node, segment)
            xi, eta, _, away, n = project_node(x, segment, p, 0.25, 0.25)
            distance = np.sqrt(dot(away, away))
            if segment["two_sided"]:
                if half - distance > ROUND_OFF * size(c):
                    to = scale(half / distance - 1.0, away) if distance > 0.0 else scale(half, n)
                    ways[t, 0], ways[t, 1], ways[t, 2] = to
            else:
                xi, eta, height, _ = height_over(segment["triangle"], c, p, xi, eta)
                depth = half - height  # beyond the depth of release it is the far side of the same solid
                if (
                    ROUND_OFF * size(c) < depth <= segment["release"]
                    and beyond(segment["triangle"], xi, eta) <= maxpar - 1.0
                ):
                    ways[t, 0], ways[t, 1], ways[t, 2] = scale(depth, n)
    return ways
