"""One step of nodes at a wall, as kernels; the equations are in the package's docstring.

`motion` (3,) is the wall's displacement, velocity and acceleration along n; `inverse_mass` of it is 0 where it stands.
`forces` (nt, 3) are r_i with friction; `reach` is how far off a node still is on the wall: the round-off of its place,
or -infinity while the wall does not act. A node that cannot meet the wall has the trial value infinity: no impulse.
`met` (nt,) is whether the wall pushed the node in the last step: then the node belongs to its front, even where another
wall has driven it behind.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import Vector, add, dot, inlined, scale, subtract
from vmharness.explicit.model.state import Array, Index
from vmharness.explicit.walls.planar.face import NORMAL, along, covers

Flags = NDArray[np.bool_]


@inlined
def row(a: Array, i: int) -> Vector:
    """Row i as a tuple."""
    return a[i, 0], a[i, 1], a[i, 2]


@kernel
def common(w: float, inverse_mass: float, trial: Array, mass: Array, nodes: Index) -> float:
    """The root w' of M (w - w') = sum m_i max(0, w' - s_i), s_i = `trial` (nt,).

    The sum is convex in w', so that Newton's method comes down from w to the root, which it meets after finitely many
    steps: each is exact for the nodes that it counts.
    """
    root = w
    while True:
        momentum, weight = w, 1.0  # divided by M
        for k in range(nodes.size):
            if trial[k] < root:
                ratio = inverse_mass * mass[nodes[k]]
                momentum += ratio * trial[k]
                weight += ratio
        lower = momentum / weight
        if not lower < root:
            return root
        root = lower


@kernel
def press(
    x: Array, v: Array, a: Array, mass: Array, dt: float, nodes: Index, face: Array, reach: float,
    motion: Array, inverse_mass: float, friction: float, forces: Array, trial: Array,
) -> float:  # fmt: skip
    """Add the forces r_i on the nodes on the wall, which are kept, to their accelerations.

    Returns the work of the wall on the nodes in the step dt that led here, 1/2 (r_{n-1} + r_n) . dt v_{n-1/2}.
    """
    n = row(face, NORMAL)
    for k in range(nodes.size):
        p = row(x, nodes[k])
        on = abs(along(face, NORMAL, p) - motion[0]) <= reach and covers(face, p)
        trial[k] = dot(n, row(a, nodes[k])) if on else np.inf
    motion[2] = common(0.0, inverse_mass, trial, mass, nodes)

    work = 0.0
    for k in range(nodes.size):
        i = nodes[k]
        velocity = row(v, i)
        work += 0.5 * dt * dot(row(forces, k), velocity)
        push = mass[i] * max(0.0, motion[2] - trial[k])
        force = scale(push, n)
        if push > 0.0 and friction > 0.0:
            force = add(force, hold(row(a, i), velocity, mass[i], dt, n, friction * push))
        for j in range(3):
            forces[k, j] = force[j]
            a[i, j] += force[j] / mass[i]
        work += 0.5 * dt * dot(force, velocity)
    return work


@kernel
def hold(a: Vector, v: Vector, mass: float, dt: float, n: Vector, limit: float) -> Vector:
    """The friction that ends sliding within the step dt, m (v/dt + a) across n, up to `limit`."""
    demand = across(scale(-mass, add(scale(1.0 / dt, v), a) if dt > 0.0 else a), n)
    return scale(share(demand, limit), demand)


@kernel
def strike(
    x: Array, v: Array, a: Array, mass: Array, mean_dt: float, dt: float, nodes: Index, face: Array,
    reach: float, motion: Array, inverse_mass: float, friction: float, forces: Array, trial: Array, met: Flags,
    impulse: Array,
) -> float:  # fmt: skip
    """Move wall and nodes to velocities at t_{n+1/2} with which no node of the front ends the step dt behind the wall.

    The forces r_i have acted for `mean_dt`; with p_i beyond r_i mean_dt, the sum of which `impulse` (3,) receives,
    friction is that of both. Returns the work of the p_i at t_n, p . (v_n + v_n + p/m)/2.
    """
    n = row(face, NORMAL)
    motion[1] += mean_dt * motion[2]
    for k in range(nodes.size):
        p, velocity = row(x, nodes[k]), row(v, nodes[k])
        near = -np.inf if met[k] else -reach  # a node of the front is not behind this
        caught = reach >= 0.0 and along(face, NORMAL, p) - motion[0] >= near
        trial[k] = approach(p, velocity, dt, face, motion[0], motion[1]) if caught else np.inf
    motion[1] = common(motion[1], inverse_mass, trial, mass, nodes)
    motion[0] += dt * motion[1]

    work = 0.0
    impulse[:] = 0.0
    for k in range(nodes.size):
        i = nodes[k]
        blow = mass[i] * max(0.0, motion[1] - trial[k])
        given = scale(mean_dt, row(forces, k))
        p = scale(blow, n)
        total = blow + dot(given, n)
        met[k] = total > 0.0
        if friction > 0.0 and total > 0.0:
            held = across(given, n)
            demand = subtract(held, across(scale(mass[i], row(v, i)), n))
            p = add(p, subtract(scale(share(demand, friction * total), demand), held))
        change = scale(1.0 / mass[i], p)
        mean = subtract(add(row(v, i), scale(0.5, change)), scale(0.5 * dt, row(a, i)))
        work += dot(p, mean)
        for j in range(3):
            v[i, j] += change[j]
            impulse[j] += p[j]
    return work


@kernel
def approach(x: Vector, v: Vector, dt: float, face: Array, place: float, speed: float) -> float:
    """s = u + g/dt of a node that would pass through the face within the step, else infinity."""
    gap = along(face, NORMAL, x) - place
    u = dot(row(face, NORMAL), v)
    if gap + dt * (u - speed) >= 0.0:
        return np.inf
    passed = gap / (speed - u) if gap > 0.0 else 0.0  # the time until the node is at the face
    return u + gap / dt if covers(face, add(x, scale(passed, v))) else np.inf


@inlined
def across(a: Vector, n: Vector) -> Vector:
    """a - (a . n) n."""
    return subtract(a, scale(dot(a, n), n))


@inlined
def share(demand: Vector, limit: float) -> float:
    """The part of `demand` that `limit` allows, 0 to 1."""
    size = np.sqrt(dot(demand, demand))
    return limit / size if size > limit else 1.0
