"""The work of a contact on what moves: what the springs store, what dampers and friction take.

Over a step it is -(f_{n-1} + f_n)/2 . dt v_{n-1/2}, each half with the contact point of its own time; the second half
is added where the force is made (`push`), and what slips is moved from there to the energy of friction (`friction`).

A spring that is let go while it is pressed (too deep, beyond the end of its surface, at the death of the contact)
gives its energy to nothing that moves: it is moved to the energy "released", so that "contact" holds what springs that
touch store, and what dampers have taken. One that is pressed already as it begins (on the far side of a shell that has
let a node through, at the birth of the contact) has energy that nothing gave: it is taken from there.
"""

from vmharness.explicit.contact.geometry import shape
from vmharness.explicit.contact.kinematics import carried, relative
from vmharness.explicit.contact.records import Record, Records
from vmharness.explicit.contact.stiffness import stiffness
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import add, dot, inlined, scale, subtract
from vmharness.explicit.model.state import Array


@inlined
def half_work(
    x: Array, v: Array, dt: float, node: Record, segments: Records, touch: Record, rule: Record, account: Array
) -> None:  # fmt: skip
    """The work of the force at t_{n-1} over the first half of the step."""
    row, segment = node["row"], segments[touch["segment"]]
    weights = shape(segment["triangle"], touch["xi"], touch["eta"])
    velocity = relative(v, row, segment, weights)
    if rule["friction"]:
        velocity = subtract(velocity, carried(x, v, row, segment, weights, dt))
    account[0] -= 0.5 * dt * dot((touch["force"][0], touch["force"][1], touch["force"][2]), velocity)


@uncounted
def catch(
    x: Array, v: Array, mass: Array, dt: float, node: Record, segments: Records, touch: Record, rule: Record,
    account: Array,
) -> None:  # fmt: skip
    """A touch begins at t_n: k d/2 (d + dt v_n) was there, if the node was behind at t_{n-1} already; d = -gap."""
    segment = segments[touch["segment"]]
    velocity = relative(v, node["row"], segment, shape(segment["triangle"], touch["xi"], touch["eta"]))
    before = dt * dot(velocity, (touch["normal"][0], touch["normal"][1], touch["normal"][2])) - touch["gap"]
    k = stiffness(node, segment, mass, rule["sofscl"], rule["longest"])
    found = -0.5 * k * touch["gap"] * max(0.0, before)
    account[0] += found
    account[5] -= found


@uncounted
def let_go(
    x: Array, v: Array, dt: float, node: Record, segments: Records, touch: Record, account: Array
) -> None:
    """No force is left at t_n: all that is stretched slips, and what is pressed, d = -gap, is released.

    |f_t|/2 |s + dt v_t| goes to friction, f_n/2 (d - dt v_n) to "released"; f, s, d and the normal are of t_{n-1}, v of
    the step. With the work of its first half this is all that the spring has in the account.
    """
    segment = segments[touch["segment"]]
    velocity = relative(v, node["row"], segment, shape(segment["triangle"], touch["xi"], touch["eta"]))
    n = (touch["normal"][0], touch["normal"][1], touch["normal"][2])
    leaving = dot(velocity, n)
    sliding = subtract(velocity, scale(leaving, n))
    slip = add((touch["slip"][0], touch["slip"][1], touch["slip"][2]), scale(dt, sliding))
    left = 0.5 * touch["shear"] * dot(slip, slip) ** 0.5
    force = (touch["force"][0], touch["force"][1], touch["force"][2])
    pressed = 0.5 * dot(force, n) * max(0.0, -touch["gap"] - touch["ease"] - dt * leaving)
    account[0] -= left + pressed
    account[1] += left
    account[5] += pressed
