"""Geometry of a segment r(xi, eta) = sum N_i x_i: a bilinear quadrilateral, or a flat triangle.

    quadrilateral   N_i = 1/4 (1 + xi_i xi)(1 + eta_i eta)        -1 <= xi, eta <= 1
    triangle        N = (1 - xi - eta, xi, eta, 0)                0 <= xi, eta, xi + eta <= 1

Its normal is r,xi x r,eta. `c` are the four corners; a triangle repeats its third corner, whose second N is zero.
"""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale, subtract, unit
from vmharness.explicit.state import Array

Corners: TypeAlias = tuple[Vector, Vector, Vector, Vector]
Weights: TypeAlias = tuple[float, float, float, float]


@inlined
def at(field: Array, row: int) -> Vector:
    """The vector of a field (n, 3) at a row."""
    return field[row, 0], field[row, 1], field[row, 2]


@inlined
def corners(field: Array, nodes: NDArray[np.intp]) -> Corners:
    """The vectors of a field (n, 3) at the four nodes."""
    return at(field, nodes[0]), at(field, nodes[1]), at(field, nodes[2]), at(field, nodes[3])


@inlined
def at_time(c: Corners, v: Corners, back: float) -> Corners:
    """Corners at the time t_n - back: x - back v."""
    return (
        subtract(c[0], scale(back, v[0])), subtract(c[1], scale(back, v[1])),
        subtract(c[2], scale(back, v[2])), subtract(c[3], scale(back, v[3])),
    )  # fmt: skip


@inlined
def shape(triangle: bool, xi: float, eta: float) -> Weights:
    """Shape functions N_i(xi, eta)."""
    if triangle:
        return 1.0 - xi - eta, xi, eta, 0.0
    a, b, c, d = 1.0 - xi, 1.0 + xi, 0.25 * (1.0 - eta), 0.25 * (1.0 + eta)
    return a * c, b * c, b * d, a * d


@inlined
def interpolate(c: Corners, weights: Weights) -> Vector:
    """sum N_i c_i."""
    one = add(scale(weights[0], c[0]), scale(weights[1], c[1]))
    return add(one, add(scale(weights[2], c[2]), scale(weights[3], c[3])))


@inlined
def polynomial(triangle: bool, c: Corners) -> Corners:
    """o, a, b, w of r = o + xi a + eta b + xi eta w; the twist w is zero for a parallelogram and for a triangle."""
    if triangle:
        return c[0], subtract(c[1], c[0]), subtract(c[2], c[0]), (0.0, 0.0, 0.0)
    left, right = add(c[0], c[3]), add(c[1], c[2])
    low, high = add(c[0], c[1]), add(c[2], c[3])
    w = subtract(add(c[0], c[2]), add(c[1], c[3]))
    return (
        scale(0.25, add(low, high)),
        scale(0.25, subtract(right, left)),
        scale(0.25, subtract(high, low)),
        scale(0.25, w),
    )


@inlined
def start(
    triangle: bool, c: Corners, p: Vector, xi: float, eta: float
) -> tuple[Vector, Vector, Vector, Vector]:
    """Tangents r,xi and r,eta, twist r,xi,eta, and p - r at (xi, eta)."""
    o, a, b, w = polynomial(triangle, c)
    along = add(a, scale(eta, w))  # r,xi; and r = o + eta b + xi r,xi
    away = subtract(p, add(o, add(scale(eta, b), scale(xi, along))))
    return along, add(b, scale(xi, w)), w, away


@inlined
def tangents(triangle: bool, c: Corners, xi: float, eta: float) -> tuple[Vector, Vector]:
    """r,xi and r,eta."""
    _, a, b, w = polynomial(triangle, c)
    return add(a, scale(eta, w)), add(b, scale(xi, w))


@inlined
def normal(triangle: bool, c: Corners, xi: float, eta: float) -> Vector:
    """The unit normal r,xi x r,eta / |...|."""
    a, b = tangents(triangle, c, xi, eta)
    return unit(cross(a, b))


@inlined
def size(c: Corners) -> float:
    """A length of the segment: the square root of twice its area."""
    area = cross(subtract(c[2], c[0]), subtract(c[3], c[1]))
    return float(dot(area, area) ** 0.25)


@inlined
def centre(triangle: bool) -> tuple[float, float]:
    """(xi, eta) of the centre of a segment: first guess of its closest point."""
    return (1.0 / 3.0, 1.0 / 3.0) if triangle else (0.0, 0.0)


@inlined
def beyond(triangle: bool, xi: float, eta: float) -> float:
    """Distance outside the segment, in xi and eta of a quadrilateral (a side is 2 long); negative within."""
    if triangle:
        return 2.0 * max(-xi, -eta, xi + eta - 1.0)
    return max(abs(xi), abs(eta)) - 1.0
