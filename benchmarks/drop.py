"""A thousand loose blocks dropped into a box: `python benchmarks/drop.py [BLOCKS A SIDE]`.

Each block is one fully integrated solid, its edge 1, its density 1, gravity 1; the box is rigid shells. A single
contact with friction and damping holds all of them. Printed are the kinetic energy beside its peak when the pile has
come to rest, the deepest node seen in another block or in a wall, the blocks that left the box, and the energy ratio.
Depths are measured from the geometry of the blocks alone, apart from what the contact knows; so is that of the edges,
which a contact of nodes and segments does not hold off each other.
"""

import sys
import time
from typing import NamedTuple

import numpy as np
from meshes import deck, quadrilaterals, rows
from numpy.typing import NDArray

from vmharness.explicit import energy
from vmharness.explicit.build import build
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.force import Force
from vmharness.explicit.loop import steps
from vmharness.explicit.model.model import Model

Array = NDArray[np.float64]

SPACING, SHIFT, TURN = 1.15, 0.03, 0.04  # of the lattice; at most to each side; radians
THICKNESS = 0.4  # of the walls
FALL = 0.5  # beneath the lowest blocks
REST = 1e-4  # of the greatest kinetic energy
STAYS = 1.0  # for so long
LONGEST = 200.0  # and no longer

HEAD = """*SECTION_SHELL
         1         2    0.8333         3
       0.4
*MAT_RIGID
1,1.0,9.6e5,0.2
1,7,7

*SECTION_SOLID
2,2
*MAT_ELASTIC
2,1.0,9.6e5,0.2
*PART
blocks
2,2,2
*LOAD_BODY_Z
1,1.0
*DEFINE_CURVE
1
0.0,1.0
1e3,1.0
*CONTACT_AUTOMATIC_SINGLE_SURFACE
0
0.3,0.3,0.0,0.0,15.0

*CONTROL_CONTACT
0.03

*CONTROL_TIMESTEP
0.0,0.5
*CONTROL_ENERGY
2,2,2,2
"""

CORNERS = (
    np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]) - 0.5
)
FACES = np.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
EDGES = np.array(
    [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
)


class Outcome(NamedTuple):
    """Of a drop."""

    ended: float  # time
    cycles: int
    kinetic: float  # the largest of the last stretch, over the greatest
    deepest: float  # node in a block or wall, over an edge
    edges: float  # deepest point of an edge at the end, over an edge
    out: int  # blocks with their middle outside the box
    ratio: float  # the energy ratio furthest from 1, since something has fallen
    seconds: float


def pile(side: int) -> Array:
    """Corners (blocks, 8, 3) of the blocks, shifted and turned a little from a lattice."""
    rng = np.random.default_rng(4)
    places = np.indices((side, side, side)).reshape(3, -1).T * SPACING + 0.5 * SPACING
    places[:, 2] += FALL + 0.5 * THICKNESS
    places += rng.uniform(-SHIFT, SHIFT, places.shape)
    turns = np.array([rotation(w) for w in rng.uniform(-TURN, TURN, places.shape)])
    return places[:, None] + np.einsum("bij,cj->bci", turns, CORNERS)


def rotation(w: Array) -> Array:
    """The rotation by the vector w (Rodrigues)."""
    angle = np.linalg.norm(w)
    k = np.cross(np.eye(3), w / angle)  # k a = a x w / |w|
    return np.eye(3) - np.sin(angle) * k + (1.0 - np.cos(angle)) * k @ k


def box(side: int) -> tuple[Array, NDArray[np.int64]]:
    """Nodes (n, 3) and quadrilaterals of a floor and four walls around the lattice."""
    n, margin = side + 1, 0.5 * THICKNESS + 0.5 * (SPACING - 1.0)
    width = (side * SPACING + 2.0 * margin) / n
    high = int(np.ceil((side * SPACING + 2.0) / width))
    (i, j), (a, k) = np.indices((n + 1, n + 1)), np.indices((n + 1, high + 1))
    zero, full = np.zeros_like(a), np.full_like(a, n)
    planes = [(i, j, np.zeros_like(i)), (zero, a, k), (full, a, k), (a, zero, k), (a, full, k)]
    points, corners, first = [], [], 0
    for plane in planes:
        points.append(np.stack(plane, axis=-1).reshape(-1, 3))
        numbers = first + np.arange(points[-1].shape[0]).reshape(plane[0].shape)
        corners.append(quadrilaterals(numbers))
        first += points[-1].shape[0]
    merged, place = np.unique(np.concatenate(points), axis=0, return_inverse=True)
    return merged * width - np.array([margin, margin, 0.0]), place.ravel()[np.concatenate(corners)]


def drop(side: int) -> Model:
    """side x side x side blocks over the box."""
    blocks, (nodes, shells) = pile(side), box(side)
    x = np.concatenate([blocks.reshape(-1, 3), nodes])
    solids = np.arange(8 * side**3).reshape(-1, 8) + 1
    lines = [f"{n:8d}" + "".join(f"{a:16.9f}" for a in point) for n, point in enumerate(x.tolist(), 1)]
    lines += ["*ELEMENT_SOLID", *rows(solids, 2)]
    lines += ["*ELEMENT_SHELL", *rows(shells + 8 * side**3 + 1, 1, side**3 + 1)]
    model = build(deck(HEAD + "*NODE\n" + "\n".join(lines)))
    model.end_time = LONGEST
    return model


def depths(points: Array, owner: NDArray[np.int64], blocks: Array) -> Array:
    """How deep each of the points (n, 3) of blocks `owner` (n,) lies in another of the blocks (m, 8, 3); 0 outside."""
    faces = blocks[:, FACES]
    middle, normal = (
        faces.mean(axis=2),
        np.cross(faces[:, :, 2] - faces[:, :, 0], faces[:, :, 3] - faces[:, :, 1]),
    )
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    centre, deepest = blocks.mean(axis=1), np.zeros(owner.size)
    for b in range(len(blocks)):
        near = np.flatnonzero((abs(points - centre[b]) < 1.0).all(axis=1) & (owner != b))
        to = middle[b][:, None] - points[near]
        depth = np.einsum("fpi,fi->fp", to, normal[b]).min(axis=0)
        deepest[near] = np.maximum(deepest[near], depth)
    return deepest


def node_depth(blocks: Array, walls: Array) -> float:
    """The deepest node of a block in another, or in the floor or the side walls, which lie between `walls` (2, 3)."""
    points = blocks.reshape(-1, 3)
    within = depths(points, np.repeat(np.arange(len(blocks)), 8), blocks).max()
    low, high = walls[0] + 0.5 * THICKNESS - points, points[:, :2] + 0.5 * THICKNESS - walls[1, :2]
    return float(max(within, low.max(), high.max()))


def edge_depth(blocks: Array) -> float:
    """The deepest of nine points along each edge of a block in another."""
    ends, along = blocks[:, EDGES], np.arange(0.1, 0.95, 0.1)[:, None, None, None]
    points = (1.0 - along) * ends[:, :, 0] + along * ends[:, :, 1]  # (9, m, 12, 3)
    owner = np.broadcast_to(np.arange(len(blocks))[:, None], points.shape[:3])
    return float(depths(points.reshape(-1, 3), owner.ravel(), blocks).max())


def figures(side: int, every: int = 100) -> Outcome:
    """Let the pile fall until it rests; look every so many cycles, and for penetration every tenth time."""
    model, began = drop(side), time.perf_counter()
    items: list[Force | Constraint] = [*model.forces, *model.constraints]
    stored, work = energy.stored(items), energy.accounts(items, "external work")
    count = 8 * side**3
    blocks, nodes = model.state.x[:count].reshape(-1, 8, 3), model.state.x[count:]
    walls = np.array([nodes.min(axis=0), nodes.max(axis=0)])
    peak = last = moved = deepest = 0.0
    ratios = [1.0]
    for s in steps(model):
        if s.cycle % every:
            continue
        kinetic = model.kinetic()
        peak = max(peak, kinetic)
        last = max(last, kinetic)
        if kinetic > REST * peak or not kinetic:
            moved, last = s.t, 0.0  # the last time that it did not rest
        put_in = sum(account.item() for account in work)
        if put_in > 0.01 * count / 8:
            ratios.append((kinetic + sum(account.item() for account in stored)) / put_in)
        rests = s.t > moved + STAYS
        if rests or s.cycle % (10 * every) == 0:
            deepest = max(deepest, node_depth(blocks, walls))
        if rests:
            break
    middles = blocks.mean(axis=1)
    out = ((middles < walls[0]) | (middles > walls[1])).any(axis=1).sum()
    return Outcome(
        s.t, s.cycle, last / peak, deepest, edge_depth(blocks), int(out), max(ratios, key=lambda r: abs(r - 1.0)),
        time.perf_counter() - began,
    )  # fmt: skip


if __name__ == "__main__":
    side = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    found = figures(side)
    print(f"{side**3} blocks fell for {found.ended:.1f}, {found.cycles} cycles, in {found.seconds:.0f} s")
    print(f"kinetic energy over its peak         {found.kinetic:.1e}   (at most {REST:g})")
    print(f"deepest node, of an edge             {found.deepest:.2%}   (at most 2 %)")
    print(f"blocks that left the box             {found.out}   (none)")
    print(f"energy ratio furthest from 1         {found.ratio:.4f}   (within 2 %)")
    print(f"deepest point of an edge at the end  {found.edges:.2%}   (edges are not tracked)")
