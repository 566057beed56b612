"""The force of a touch: spring, damper and friction on the node, and the reaction on the segment.

    f = k |g| n - c (n . v) n + f_t        f_i = -N_i(xi, eta) f

g is the gap along n, v the velocity of the node against the point that it touches, v - sum N_i v_i. Forces are in
balance since sum N_i = 1; so are moments without friction, since f acts along the line between the two points.
"""

from vmharness.explicit.compiled import kernel
from vmharness.explicit.penalty.damping import coefficient
from vmharness.explicit.penalty.friction import limit, stretch, tangential, turned
from vmharness.explicit.penalty.stiffness import stiffness
from vmharness.explicit.penalty.touch import Record, Records
from vmharness.explicit.segment import Weights, at, corners, interpolate, shape
from vmharness.explicit.state import Array
from vmharness.explicit.vector import Vector, add, dot, inlined, scale, subtract


@inlined
def relative(field: Array, row: int, segment: Record, weights: Weights) -> Vector:
    """v - sum N_i v_i of a field (n, 3)."""
    return subtract(at(field, row), interpolate(corners(field, segment["nodes"]), weights))


@kernel
def push(
    f: Array, x: Array, v: Array, a: Array, mass: Array, dt: float, node: Record, segments: Records, touch: Record,
    rule: Record, account: Array,
) -> None:  # fmt: skip
    """Add the force of a touch that lies where it is at t_n, and its work over the second half of the step."""
    row, segment = node["row"], segments[touch["segment"]]
    weights = shape(segment["triangle"], touch["xi"], touch["eta"])
    n, velocity = (
        (touch["normal"][0], touch["normal"][1], touch["normal"][2]),
        relative(v, row, segment, weights),
    )
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
        force = add(force, rub(x, v, dt, node, segment, touch, rule, account, k, pressing, velocity, n))
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


@kernel
def rub(
    x: Array, v: Array, dt: float, node: Record, segment: Record, touch: Record, rule: Record, account: Array,
    k: float, pressing: float, velocity: Vector, n: Vector,
) -> Vector:  # fmt: skip
    """The friction force; what slips is taken from the contact's energy to the friction's."""
    sliding = tangential(velocity, n)
    nodes, slip = segment["nodes"], (touch["slip"][0], touch["slip"][1], touch["slip"][2])
    if dot(slip, slip) > 0.0:
        new, moved = corners(x, nodes), corners(v, nodes)
        old = (
            add(new[0], scale(-dt, moved[0])), add(new[1], scale(-dt, moved[1])),
            add(new[2], scale(-dt, moved[2])), add(new[3], scale(-dt, moved[3])),
        )  # fmt: skip
        slip = turned(segment["triangle"], old, new, touch["xi"], touch["eta"], slip, n)
    speed = dot(sliding, sliding) ** 0.5
    most = limit(pressing, speed, rule["fs"], rule["fd"], rule["dc"], rule["vc"] * node["area"])
    slip, slipped = stretch(slip, scale(dt, sliding), k, most)
    shear = k * dot(slip, slip) ** 0.5
    dissipated = 0.5 * (touch["shear"] + shear) * slipped
    account[0] -= dissipated
    account[1] += dissipated
    touch["shear"] = shear
    touch["slip"][0], touch["slip"][1], touch["slip"][2] = slip
    return scale(-k, slip)


@kernel
def half_work(v: Array, dt: float, node: Record, segments: Records, touch: Record, account: Array) -> None:
    """The work of the force at t_{n-1} over the first half of the step."""
    segment = segments[touch["segment"]]
    velocity = relative(v, node["row"], segment, shape(segment["triangle"], touch["xi"], touch["eta"]))
    account[0] -= 0.5 * dt * dot((touch["force"][0], touch["force"][1], touch["force"][2]), velocity)


@kernel
def let_go(touch: Record, account: Array) -> None:
    """What is left in the spring that stuck is lost to friction."""
    slip = (touch["slip"][0], touch["slip"][1], touch["slip"][2])
    left = 0.5 * touch["shear"] * dot(slip, slip) ** 0.5
    account[0] -= left
    account[1] += left
