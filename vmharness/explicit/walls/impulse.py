"""One step of nodes at a wall, as kernels; the equations are in the docstring of the package.

`motion` (3,) is the wall's displacement, velocity and acceleration along n; its `inverse_mass` is 0 if it stands.
`forces` (nt, 3) are r_i with friction. A node within `reach` of the plane is on the wall: `reach` is the round-off of
coordinates, or -infinity while the wall does not act. `trial` (nt,) is s_i or a_i . n, and infinity for a node that
cannot meet the wall: no impulse. `in_front` (nt,) is true for a node that the wall pushed in the last step: it belongs
to the front of the wall, even where another wall has moved it behind.
"""

import numpy as np

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import Vector, add, dot, inlined, row, scale, subtract
from vmharness.explicit.state import Array, Flags, Index
from vmharness.explicit.walls.face import NORMAL, coordinate, covers


@kernel
def common_velocity(w: float, inverse_mass: float, trial: Array, mass: Array, nodes: Index) -> float:
    """The root w' of M (w - w') = sum m_i max(0, w' - s_i), s_i = `trial` (nt,).

    The sum is convex and piecewise linear in w', so that Newton's method descends from w to the root, and reaches it
    after finitely many iterations.
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
def add_wall_forces(
    x: Array, v: Array, a: Array, mass: Array, dt: float, nodes: Index, face: Array, reach: float,
    motion: Array, inverse_mass: float, friction: float, forces: Array, trial: Array,
) -> float:  # fmt: skip
    """Set the forces r_i on the nodes on the wall, and add them to the accelerations.

    Return the work of the wall on the nodes in the step dt that led here, 1/2 (r_{n-1} + r_n) . dt v_{n-1/2}.
    """
    n = row(face, NORMAL)
    for k in range(nodes.size):
        p = row(x, nodes[k])
        on = abs(coordinate(face, NORMAL, p) - motion[0]) <= reach and covers(face, p)
        trial[k] = dot(n, row(a, nodes[k])) if on else np.inf
    motion[2] = common_velocity(0.0, inverse_mass, trial, mass, nodes)

    work = 0.0
    for k in range(nodes.size):
        i = nodes[k]
        velocity = row(v, i)
        work += 0.5 * dt * dot(row(forces, k), velocity)
        normal_force = mass[i] * max(0.0, motion[2] - trial[k])
        force = scale(normal_force, n)
        if normal_force > 0.0 and friction > 0.0:
            force = add(
                force, stopping_friction(row(a, i), velocity, mass[i], dt, n, friction * normal_force)
            )
        for j in range(3):
            forces[k, j] = force[j]
            a[i, j] += force[j] / mass[i]
        work += 0.5 * dt * dot(force, velocity)
    return work


@kernel
def stopping_friction(a: Vector, v: Vector, mass: float, dt: float, n: Vector, limit: float) -> Vector:
    """The friction that ends sliding within the step dt, m (v/dt + a) across n, up to `limit`."""
    demand = tangential(scale(-mass, add(scale(1.0 / dt, v), a) if dt > 0.0 else a), n)
    return scale(allowed_fraction(demand, limit), demand)


@kernel
def add_impulses(
    x: Array, v: Array, a: Array, mass: Array, mean_dt: float, dt: float, nodes: Index, face: Array,
    reach: float, motion: Array, inverse_mass: float, friction: float, forces: Array, trial: Array, in_front: Flags,
    impulse: Array,
) -> float:  # fmt: skip
    """Change velocities at t_{n+1/2} of wall and nodes so that no node in front ends the step dt behind the wall.

    The impulses p_i are those beyond r_i mean_dt, the impulses of the forces; `impulse` (3,) is their sum. The limit of
    friction counts both. Return the work of the p_i at t_n, p . (v_n + v_n + p/m)/2.
    """
    n = row(face, NORMAL)
    motion[1] += mean_dt * motion[2]
    for k in range(nodes.size):
        p, velocity = row(x, nodes[k]), row(v, nodes[k])
        lowest = -np.inf if in_front[k] else -reach
        may_meet = reach >= 0.0 and coordinate(face, NORMAL, p) - motion[0] >= lowest
        trial[k] = trial_velocity(p, velocity, dt, face, motion[0], motion[1]) if may_meet else np.inf
    motion[1] = common_velocity(motion[1], inverse_mass, trial, mass, nodes)
    motion[0] += dt * motion[1]

    work = 0.0
    impulse[:] = 0.0
    for k in range(nodes.size):
        i = nodes[k]
        normal_impulse = mass[i] * max(0.0, motion[1] - trial[k])
        by_force = scale(mean_dt, row(forces, k))
        p = scale(normal_impulse, n)
        total = normal_impulse + dot(by_force, n)
        in_front[k] = total > 0.0
        if friction > 0.0 and total > 0.0:
            friction_so_far = tangential(by_force, n)
            demand = subtract(friction_so_far, tangential(scale(mass[i], row(v, i)), n))
            p = add(p, subtract(scale(allowed_fraction(demand, friction * total), demand), friction_so_far))
        change = scale(1.0 / mass[i], p)
        mean = subtract(add(row(v, i), scale(0.5, change)), scale(0.5 * dt, row(a, i)))
        work += dot(p, mean)
        for j in range(3):
            v[i, j] += change[j]
            impulse[j] += p[j]
    return work


@kernel
def trial_velocity(x: Vector, v: Vector, dt: float, face: Array, position: float, speed: float) -> float:
    """s = u + g/dt of a node that would pass through the face within the step; infinity for any other."""
    gap = coordinate(face, NORMAL, x) - position
    u = dot(row(face, NORMAL), v)
    if gap + dt * (u - speed) >= 0.0:
        return np.inf
    arrival = gap / (speed - u) if gap > 0.0 else 0.0  # the time until the node is at the face
    return u + gap / dt if covers(face, add(x, scale(arrival, v))) else np.inf


@inlined
def tangential(a: Vector, n: Vector) -> Vector:
    """The component of a across n, a - (a . n) n."""
    return subtract(a, scale(dot(a, n), n))


@inlined
def allowed_fraction(demand: Vector, limit: float) -> float:
    """The largest fraction of `demand`, at most 1, whose size does not exceed `limit`."""
    size = np.sqrt(dot(demand, demand))
    return limit / size if size > limit else 1.0
