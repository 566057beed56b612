"""Coulomb friction with an elastic spring that sticks (LS-DYNA theory manual, trial force and return to the cone).

    trial    f* = -k (s + dt v_t)                      s the stretch so far, rotated with the segment
    limit    f_max = min(mu f_n, VC A)                 mu = FD + (FS - FD) exp(-DC |v_t|)
    |f*| <= f_max: stick, s grows;  else: slip, s = -f/k with f = f_max f*/|f*|

The slip ds dissipates (|f_{n-1}| + |f_n|)/2 |ds|; the spring gives its energy back while it sticks.
"""

import numpy as np

from vmharness.explicit.contact.geometry import Corners, at_time, corners, tangents
from vmharness.explicit.contact.records import CONTACT, FRICTION, Record, vector_of
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import (
    Vector,
    add,
    combine,
    components,
    cross,
    dot,
    inlined,
    scale,
    subtract,
    unit,
)
from vmharness.explicit.state import Array


@uncounted
def friction_force(
    # model
    segment: Record, parameters: Record,
    # motion, relative velocity, normal
    x: Array, v: Array, dt: float, velocity: Vector, n: Vector,
    # stiffness, normal force
    k: float, pressing: float,
    # updated
    node: Record, state: Record, account: Array,
) -> Vector:  # fmt: skip
    """Return the friction force on the node; move the energy that slip dissipates from "contact" to "friction"."""
    sliding = tangential(velocity, n)
    nodes, slip = segment["nodes"], vector_of(state["slip"])
    if dot(slip, slip) > 0.0:
        new = corners(x, nodes)
        old = at_time(new, corners(v, nodes), dt)
        slip = rotate(segment["triangle"], old, new, state["xi"], state["eta"], slip, n)
    speed = dot(sliding, sliding) ** 0.5
    most = friction_limit(
        pressing, speed, parameters["fs"], parameters["fd"], parameters["dc"], parameters["vc"] * node["area"]
    )
    slip, slipped = return_to_cone(slip, scale(dt, sliding), k, most)
    shear = k * dot(slip, slip) ** 0.5
    dissipated = 0.5 * (state["shear"] + shear) * slipped
    account[CONTACT] -= dissipated
    account[FRICTION] += dissipated
    state["shear"] = shear
    state["slip"][0], state["slip"][1], state["slip"][2] = slip
    return scale(-k, slip)


@inlined
def friction_limit(pressing: float, speed: float, fs: float, fd: float, dc: float, vc_area: float) -> float:
    """The largest friction force, min(mu f_n, VC A)."""
    mu = fd + (fs - fd) * np.exp(-dc * speed) if fs != fd else fs
    return float(min(mu * pressing, vc_area))


@uncounted
def return_to_cone(slip: Vector, increment: Vector, k: float, most: float) -> tuple[Vector, float]:
    """The stretch s of the spring after an increment, with k |s| <= `most`, and how much of the increment slips."""
    trial = add(slip, increment)
    length = dot(trial, trial) ** 0.5
    if k * length <= most:
        return trial, 0.0
    return scale(most / (k * length), trial), length - most / k


@inlined
def tangential(a: Vector, n: Vector) -> Vector:
    """a - (a . n) n."""
    return subtract(a, scale(dot(a, n), n))


@inlined
def triad(triangle: bool, c: Corners, xi: float, eta: float) -> tuple[Vector, Vector, Vector]:
    """Unit vectors along r,xi, across it, and normal."""
    a, b = tangents(triangle, c, xi, eta)
    e1, e3 = unit(a), unit(cross(a, b))
    return e1, cross(e3, e1), e3


@uncounted
def rotate(triangle: bool, old: Corners, new: Corners, xi: float, eta: float, a: Vector, n: Vector) -> Vector:
    """Rotate the vector a with the segment from `old` to `new`, then project it across n at the same length."""
    rotated = combine(triad(triangle, new, xi, eta), components(triad(triangle, old, xi, eta), a))
    across = tangential(rotated, n)
    length = dot(across, across) ** 0.5
    return scale(dot(a, a) ** 0.5 / length, across) if length > 0.0 else across
