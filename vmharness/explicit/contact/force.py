"""The force of a touch: spring, damper and friction on the node, and the reaction on the segment.

    f = k |g| n - c (n . v) n + f_t        f_i = -N_i(xi, eta) f

g is the gap along n, v the velocity of the node against the point that it touches, v - sum N_i v_i. Forces are in
balance since sum N_i = 1; so are moments without friction, since f acts along the line between the two points, and
with friction by a couple (see `couple`).
"""

from vmharness.explicit.contact.damping import coefficient
from vmharness.explicit.contact.friction import rub
from vmharness.explicit.contact.geometry import Weights, at, corners, interpolate, shape
from vmharness.explicit.contact.kinematics import carried, relative
from vmharness.explicit.contact.moment_balance import about_middle, turn
from vmharness.explicit.contact.records import Record, Records
from vmharness.explicit.contact.stiffness import stiffness
from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale, subtract
from vmharness.explicit.model.state import Array


@inlined
def push(
    f: Array, x: Array, v: Array, a: Array, mass: Array, dt: float, node: Record, segments: Records, touch: Record,
    rule: Record, account: Array,
) -> None:  # fmt: skip
    """Add the force of a touch that lies where it is at t_n, and its work over the second half of the step."""
    row, segment = node["row"], segments[touch["segment"]]
    weights = shape(segment["triangle"], touch["xi"], touch["eta"])
    n = (touch["normal"][0], touch["normal"][1], touch["normal"][2])
    velocity = relative(v, row, segment, weights)
    k = stiffness(node, segment, mass, rule["sofscl"], rule["longest"])
    touch["ease"] = min(touch["ease"], -touch["gap"])
    pressing = k * (-touch["gap"] - touch["ease"])
    if rule["vdc"] > 0.0:
        nodes, m_m = segment["nodes"], 0.0
        for i in range(4):
            m_m += weights[i] * mass[nodes[i]]
        now = add(velocity, scale(0.5 * dt, relative(a, row, segment, weights)))
        pressing = max(0.0, pressing - coefficient(rule["vdc"], k, mass[row], m_m) * dot(n, now))
    force = scale(pressing, n)
    if rule["friction"]:
        velocity = subtract(velocity, carried(x, v, row, segment, weights, 0.0))
        rubbing = rub(x, v, dt, node, segment, touch, rule, account, k, pressing, velocity, n)
        balance(f, x, row, segment, weights, rubbing)
        force = add(force, rubbing)
    apply(f, row, segment, weights, force)
    account[0] -= 0.5 * dt * dot(force, velocity)
    for j in range(3):
        touch["force"][j] = force[j]
        node["force"][j] += force[j]
        account[2 + j] += force[j]


@inlined
def apply(f: Array, row: int, segment: Record, weights: Weights, force: Vector) -> None:
    """Force on the node, its reaction on the segment."""
    nodes = segment["nodes"]
    for j in range(3):
        f[row, j] += force[j]
    for i in range(4):
        for j in range(3):
            f[nodes[i], j] -= weights[i] * force[j]


@inlined
def balance(f: Array, x: Array, row: int, segment: Record, weights: Weights, force: Vector) -> None:
    """Add the couple -w x f to the segment's nodes."""
    nodes = segment["nodes"]
    c = corners(x, nodes)
    r = about_middle(c)
    omega = turn(r, cross(force, subtract(at(x, row), interpolate(c, weights))))
    pairs = (cross(omega, r[0]), cross(omega, r[1]), cross(omega, r[2]), cross(omega, r[3]))
    for j in range(3):
        f[nodes[0], j] += pairs[0][j]
        f[nodes[1], j] += pairs[1][j]
        f[nodes[2], j] += pairs[2][j]
        f[nodes[3], j] += pairs[3][j]
