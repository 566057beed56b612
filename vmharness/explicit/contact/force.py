"""The contact force: spring, damper and friction on the node, and the reaction on the segment.

    f = k |g| n - c (n . v) n + f_t        f_i = -N_i(xi, eta) f

g is the gap along n, v = v_node - sum N_i v_i the velocity of the node relative to the contact point. Forces are in
balance since sum N_i = 1; so are moments without friction, since f acts along the line between the two points, and with
friction by `moment_balance`.

Stiffness

    SOFT 0   k = min(k_segment, k_node)                       (PENOPT 1)
    SOFT 1   k = max(that, SOFSCL m* / dt^2)                  m* the least mass of the node and the segment's nodes

`k_segment` and `k_node` include SLSFAC and SFSA or SFSB. SOFT 1 is our reading of LSTC's FAQ contact.soft1, which has a
stiffness from nodal masses and the time step, with the least of the masses. dt is the longest step so far: with a step
that shrinks, the stiffness stays, and no energy is made. Nodes of rigid bodies count with their shares of the mass;
nodes without mass are held by something that is no rigid body, and are left out.

Damping, VDC in percent of critical

    c = VDC/100 * 2 m w      w = sqrt(k (m_s + m_m)/(m_s m_m))      m = min(m_s, m_m)

m_s is the node's mass, m_m that of the segment at the contact point, sum N_i m_i; nodes of rigid bodies have shares of
the body's mass (rigid/mass_shares.py). A segment without mass is held, as is one that is much heavier: then
c = VDC/100 * 2 sqrt(k m_s), the critical damping of the node on its spring. Damping acts on the velocity of the gap at
t_n, v_{n-1/2} + dt/2 a_{n-1}, which keeps the order of the time integration.

Spring and damper together do not pull: contact ends at zero force, not at zero penetration, so that a fraction z of
critical damping gives back a little more than exp(-pi z / sqrt(1 - z^2)) of the velocity.
"""

import numpy as np

from vmharness.explicit.contact.friction import friction_force
from vmharness.explicit.contact.geometry import Corners, Weights, shape
from vmharness.explicit.contact.kinematics import moment_balance, relative, transport_velocity
from vmharness.explicit.contact.records import CONTACT, FORCE, Record, Records, vector_of
from vmharness.explicit.kernels.vector import Vector, add, dot, inlined, scale, subtract
from vmharness.explicit.state import Array


@inlined
def add_contact_force(
    # model
    mass: Array, segments: Records, parameters: Record,
    # motion
    x: Array, v: Array, a: Array, dt: float,
    # updated
    f: Array, node: Record, state: Record, account: Array,
) -> None:  # fmt: skip
    """Add the force of a contact at t_n, and its work over the second half of the step."""
    row, segment = node["row"], segments[state["segment"]]
    weights = shape(segment["triangle"], state["xi"], state["eta"])
    n = vector_of(state["normal"])
    velocity = relative(v, row, segment, weights)
    k = stiffness(node, segment, mass, parameters["sofscl"], parameters["longest_step"])
    state["offset"] = min(state["offset"], -state["gap"])
    pressing = k * (-state["gap"] - state["offset"])
    if parameters["vdc"] > 0.0:
        nodes, m_m = segment["nodes"], 0.0
        for i in range(4):
            m_m += weights[i] * mass[nodes[i]]
        now = add(velocity, scale(0.5 * dt, relative(a, row, segment, weights)))
        c = damping_coefficient(parameters["vdc"], k, mass[row], m_m)
        pressing = max(0.0, pressing - c * dot(n, now))
    force = scale(pressing, n)
    if parameters["friction"]:
        velocity = subtract(velocity, transport_velocity(x, v, row, segment, weights, 0.0))
        friction = friction_force(
            segment, parameters, x, v, dt, velocity, n, k, pressing, node, state, account
        )
        add_to_segment(f, segment, moment_balance(x, row, segment, weights, friction))
        force = add(force, friction)
    add_pair(f, row, segment, weights, force)
    account[CONTACT] -= 0.5 * dt * dot(force, velocity)
    for j in range(3):
        state["force"][j] = force[j]
        node["force"][j] += force[j]
        account[FORCE + j] += force[j]


@inlined
def stiffness(node: Record, segment: Record, mass: Array, sofscl: float, longest_step: float) -> float:
    """k of a node on a segment; `sofscl` is zero for SOFT 0."""
    k = min(node["penalty"], segment["penalty"])
    if sofscl > 0.0 and longest_step > 0.0:
        least = np.inf
        for i in range(5):
            m = mass[node["row"]] if i == 4 else mass[segment["nodes"][i]]
            least = min(least, m if m > 0.0 else np.inf)
        if least < np.inf:
            k = max(k, sofscl * least / longest_step**2)
    return float(k)


@inlined
def damping_coefficient(vdc: float, k: float, m_s: float, m_m: float) -> float:
    """c of a contact with stiffness k; zero for a node and a segment without mass."""
    if m_s <= 0.0 or m_m <= 0.0:
        return float(0.02 * vdc * np.sqrt(k * max(m_s, m_m)))
    return float(0.02 * vdc * min(m_s, m_m) * np.sqrt(k * (1.0 / m_s + 1.0 / m_m)))


@inlined
def add_pair(f: Array, row: int, segment: Record, weights: Weights, force: Vector) -> None:
    """Add a force on the node, and its reaction on the segment."""
    nodes = segment["nodes"]
    for j in range(3):
        f[row, j] += force[j]
    for i in range(4):
        for j in range(3):
            f[nodes[i], j] -= weights[i] * force[j]


@inlined
def add_to_segment(f: Array, segment: Record, forces: Corners) -> None:
    """Add forces on the four nodes of a segment."""
    nodes = segment["nodes"]
    for j in range(3):
        f[nodes[0], j] += forces[0][j]
        f[nodes[1], j] += forces[1][j]
        f[nodes[2], j] += forces[2][j]
        f[nodes[3], j] += forces[3][j]
