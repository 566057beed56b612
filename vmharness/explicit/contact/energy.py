"""Energy account of a contact: work of the contact forces, what slip dissipates, and what released springs contained.

The work over a step is -(f_{n-1} + f_n)/2 . dt v_{n-1/2}, each half with the contact point of its own time; the second
half is added with the force (`add_contact_force`), and what slip dissipates is moved from "contact" to "friction".

A spring whose contact ends under pressure (too deep, beyond the end of its surface, at the death of the contact) gives
its energy to nothing that moves: it is moved to the energy "released", so that "contact" contains what springs of
active contacts store, and what dampers have dissipated. A spring whose contact begins under pressure (on the far side
of a shell that has released a node, at the birth of the contact) contains energy that nothing gave: it is taken from
"released".
"""

from vmharness.explicit.contact.force import stiffness
from vmharness.explicit.contact.geometry import shape
from vmharness.explicit.contact.kinematics import relative, transport_velocity
from vmharness.explicit.contact.records import CONTACT, FRICTION, RELEASED, Record, Records, vector_of
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, add, dot, inlined, scale, subtract
from vmharness.explicit.state import Array


@inlined
def add_half_work(
    # model
    segments: Records, parameters: Record,
    # motion, contact
    x: Array, v: Array, dt: float, node: Record, state: Record,
    # updated
    account: Array,
) -> None:  # fmt: skip
    """Add the work of the force at t_{n-1} over the first half of the step."""
    row, segment = node["row"], segments[state["segment"]]
    weights = shape(segment["triangle"], state["xi"], state["eta"])
    velocity = relative(v, row, segment, weights)
    if parameters["friction"]:
        velocity = subtract(velocity, transport_velocity(x, v, row, segment, weights, dt))
    account[CONTACT] -= 0.5 * dt * dot(vector_of(state["force"]), velocity)


@uncounted
def account_activation(
    # model
    mass: Array, segments: Records, parameters: Record,
    # motion, contact
    v: Array, dt: float, node: Record, state: Record,
    # updated
    account: Array,
) -> None:  # fmt: skip
    """Take from "released" the energy of a contact that begins under pressure at t_n.

    It is k d/2 (d + dt v_n), d = -gap, if the node was behind at t_{n-1} already.
    """
    segment = segments[state["segment"]]
    velocity, n = approach(v, segment, node, state)
    before = dt * dot(velocity, n) - state["gap"]
    k = stiffness(node, segment, mass, parameters["sofscl"], parameters["longest_step"])
    found = -0.5 * k * state["gap"] * max(0.0, before)
    account[CONTACT] += found
    account[RELEASED] -= found


@uncounted
def account_release(
    # model
    segments: Records,
    # motion, contact
    v: Array, dt: float, node: Record, state: Record,
    # updated
    account: Array,
) -> None:  # fmt: skip
    """Move the energy of a contact that ends at t_n to "friction" and "released".

    |f_t|/2 |s + dt v_t| goes to friction, f_n/2 (d - dt v_n) to released, d = -gap; f, s, d and the normal are of
    t_{n-1}, v of the step. With the work of its first half this is all that the spring has in the account.
    """
    velocity, n = approach(v, segments[state["segment"]], node, state)
    leaving = dot(velocity, n)
    sliding = subtract(velocity, scale(leaving, n))
    slip = add(vector_of(state["slip"]), scale(dt, sliding))
    left = 0.5 * state["shear"] * dot(slip, slip) ** 0.5
    pressed = (
        0.5 * dot(vector_of(state["force"]), n) * max(0.0, -state["gap"] - state["offset"] - dt * leaving)
    )
    account[CONTACT] -= left + pressed
    account[FRICTION] += left
    account[RELEASED] += pressed


@inlined
def approach(v: Array, segment: Record, node: Record, state: Record) -> tuple[Vector, Vector]:
    """The relative velocity of node and contact point, and the contact normal."""
    weights = shape(segment["triangle"], state["xi"], state["eta"])
    return relative(v, node["row"], segment, weights), vector_of(state["normal"])
