"""Coulomb friction with a spring that sticks (LS-DYNA theory manual, trial force and return to the cone).

    trial    f* = -k (s + dt v_t)                      s the stretch so far, turned with the segment
    limit    f_max = min(mu f_n, VC A)                 mu = FD + (FS - FD) exp(-DC |v_t|)
    |f*| <= f_max: stick, s grows;  else: slip, s = -f/k with f = f_max f*/|f*|

What slips, ds, dissipates (|f_{n-1}| + |f_n|)/2 |ds|; what sticks is a spring and gives its energy back.
"""

import numpy as np

from vmharness.explicit.contact.geometry import Corners, at_time, corners, tangents
from vmharness.explicit.contact.records import Record
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
from vmharness.explicit.model.state import Array


@uncounted
def rub(
    x: Array, v: Array, dt: float, node: Record, segment: Record, touch: Record, rule: Record, account: Array,
    k: float, pressing: float, velocity: Vector, n: Vector,
) -> Vector:  # fmt: skip
    """The friction force; what slips is taken from the contact's energy to the friction's."""
    sliding = tangential(velocity, n)
    nodes, slip = segment["nodes"], (touch["slip"][0], touch["slip"][1], touch["slip"][2])
    if dot(slip, slip) > 0.0:
        new = corners(x, nodes)
        old = at_time(new, corners(v, nodes), dt)
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


@inlined
def limit(pressing: float, speed: float, fs: float, fd: float, dc: float, vc_area: float) -> float:
    """The largest friction force."""
    mu = fd + (fs - fd) * np.exp(-dc * speed) if fs != fd else fs
    return float(min(mu * pressing, vc_area))


@uncounted
def stretch(slip: Vector, increment: Vector, k: float, most: float) -> tuple[Vector, float]:
    """The stretch of the spring after an increment, and how much of it has slipped, with k |s| <= `most`."""
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
def turned(triangle: bool, old: Corners, new: Corners, xi: float, eta: float, a: Vector, n: Vector) -> Vector:
    """The vector a turned as the segment turns from `old` to `new`, then laid across n at the same length."""
    with_it = combine(triad(triangle, new, xi, eta), components(triad(triangle, old, xi, eta), a))
    across = tangential(with_it, n)
    length = dot(across, across) ** 0.5
    return scale(dot(a, a) ** 0.5 / length, across) if length > 0.0 else across
