"""Relative motion of a node and the segment that it is in contact with, and the moment that friction balances.

Friction acts on a node at its own place p, which lies off the contact point r of the segment, by w = p - r. Force and
reaction make a moment w x f. The segment's nodes balance it by forces that are those of a rigid rotation about the
mean of the corners:

    f_i = omega x r_i      I omega = -w x f      r_i = x_i - mean x      I = sum r_i^2 1 - r_i r_i

In the same measure the segment rotates with I omega = sum r_i x v_i, and moves the point at p by omega x w: with
this in the relative velocity, the power of friction is that of all nodal forces.
"""

from vmharness.explicit.contact.geometry import Corners, Weights, at, at_time, corners, interpolate
from vmharness.explicit.contact.records import Record
from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale, subtract
from vmharness.explicit.state import Array


@inlined
def relative(field: Array, row: int, segment: Record, weights: Weights) -> Vector:
    """v - sum N_i v_i of a field (n, 3), velocity or acceleration."""
    return subtract(at(field, row), interpolate(corners(field, segment["nodes"]), weights))


@inlined
def transport_velocity(
    x: Array, v: Array, row: int, segment: Record, weights: Weights, back: float
) -> Vector:
    """omega x w: velocity of the point of the segment, taken as rigid, at the node, relative to the contact point.

    Positions are those of the time t_n - back.
    """
    moved = corners(v, segment["nodes"])
    c = at_time(corners(x, segment["nodes"]), moved, back)
    arm = subtract(subtract(at(x, row), scale(back, at(v, row))), interpolate(c, weights))
    return cross(spin(about_mean(c), moved), arm)


@inlined
def moment_balance(x: Array, row: int, segment: Record, weights: Weights, force: Vector) -> Corners:
    """The forces omega x r_i on the segment's nodes that balance a friction force on the node."""
    c = corners(x, segment["nodes"])
    r = about_mean(c)
    omega = rotation(r, cross(force, subtract(at(x, row), interpolate(c, weights))))
    return cross(omega, r[0]), cross(omega, r[1]), cross(omega, r[2]), cross(omega, r[3])


@inlined
def about_mean(c: Corners) -> Corners:
    """r_i = x_i - mean x."""
    mean = scale(0.25, add(add(c[0], c[1]), add(c[2], c[3])))
    return subtract(c[0], mean), subtract(c[1], mean), subtract(c[2], mean), subtract(c[3], mean)


@inlined
def rotation(r: Corners, moment: Vector) -> Vector:
    """omega of I omega = moment."""
    xx = yy = zz = xy = yz = zx = 0.0
    for p in (r[0], r[1], r[2], r[3]):
        xx, yy, zz = xx + p[0] * p[0], yy + p[1] * p[1], zz + p[2] * p[2]
        xy, yz, zx = xy + p[0] * p[1], yz + p[1] * p[2], zx + p[2] * p[0]
    a, b, c = (yy + zz, -xy, -zx), (-xy, zz + xx, -yz), (-zx, -yz, xx + yy)
    bc = cross(b, c)
    inverse = (bc, cross(c, a), cross(a, b))  # I is symmetric: rows are columns
    along = dot(inverse[0], moment), dot(inverse[1], moment), dot(inverse[2], moment)
    return scale(1.0 / dot(a, bc), along)


@inlined
def spin(r: Corners, v: Corners) -> Vector:
    """omega of I omega = sum r_i x v_i."""
    one, two = add(cross(r[0], v[0]), cross(r[1], v[1])), add(cross(r[2], v[2]), cross(r[3], v[3]))
    return rotation(r, add(one, two))
