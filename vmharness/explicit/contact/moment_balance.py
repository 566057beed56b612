"""The couple by which friction balances.

A node is rubbed at its own place p, which lies off the point r of the segment that it touches, by w = p - r. Force and
reaction make a moment w x f, which the segment's nodes take as forces w x r_i of a rigid turn about their middle:

    f_i = omega x r_i      I omega = -w x f      r_i = x_i - mean x      I = sum r_i^2 1 - r_i r_i

In the same measure the segment turns with I omega = sum r_i x v_i, and carries the point at p along by omega x w: with
this in the relative velocity, the power of friction is that of all nodal forces.
"""

from vmharness.explicit.contact.geometry import Corners
from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale, subtract


@inlined
def about_middle(c: Corners) -> Corners:
    """r_i = x_i - mean x."""
    middle = scale(0.25, add(add(c[0], c[1]), add(c[2], c[3])))
    return subtract(c[0], middle), subtract(c[1], middle), subtract(c[2], middle), subtract(c[3], middle)


@inlined
def turn(r: Corners, moment: Vector) -> Vector:
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
    """omega with which corners that move at v turn about their middle."""
    one, two = add(cross(r[0], v[0]), cross(r[1], v[1])), add(cross(r[2], v[2]), cross(r[3], v[3]))
    return turn(r, add(one, two))
