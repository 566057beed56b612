"""The work of a contact on what moves: what the springs store, what dampers and friction take.

Over a step it is -(f_{n-1} + f_n)/2 . dt v_{n-1/2}, each half with the contact point of its own time; the second half
is added where the force is made (`push`), and what slips is moved from there to the energy of friction (`friction`).
"""

from vmharness.explicit.compiled import uncounted
from vmharness.explicit.penalty.motion import carried, relative
from vmharness.explicit.penalty.touch import Record, Records
from vmharness.explicit.segment import shape
from vmharness.explicit.state import Array
from vmharness.explicit.vector import add, dot, inlined, scale, subtract


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
def let_go(
    x: Array, v: Array, dt: float, node: Record, segments: Records, touch: Record, account: Array
) -> None:
    """All that is stretched slips, |f_{n-1}|/2 |s + dt v_t|, and goes to friction: no force is left at t_n."""
    segment = segments[touch["segment"]]
    velocity = relative(v, node["row"], segment, shape(segment["triangle"], touch["xi"], touch["eta"]))
    n = (touch["normal"][0], touch["normal"][1], touch["normal"][2])
    sliding = subtract(velocity, scale(dot(velocity, n), n))
    slip = add((touch["slip"][0], touch["slip"][1], touch["slip"][2]), scale(dt, sliding))
    left = 0.5 * touch["shear"] * dot(slip, slip) ** 0.5
    account[0] -= left
    account[1] += left
