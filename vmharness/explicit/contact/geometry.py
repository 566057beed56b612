"""Geometry of a segment r(xi, eta) = sum N_i x_i: a bilinear quadrilateral, or a flat triangle.

    quadrilateral   N_i = 1/4 (1 + xi_i xi)(1 + eta_i eta)        -1 <= xi, eta <= 1
    triangle        N = (1 - xi - eta, xi, eta, 0)                0 <= xi, eta, xi + eta <= 1

Its normal is r,xi x r,eta. `c` are the four corners; a triangle repeats its third, which takes no share of its own.
"""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale, subtract, unit
from vmharness.explicit.model.state import Array

Corners: TypeAlias = tuple[Vector, Vector, Vector, Vector]
Weights: TypeAlias = tuple[float, float, float, float]

ITERATIONS = 20
CONVERGED = 1e-13  # in xi and eta


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
    """Corners as they were a time `back` ago, x - back v."""
    return (
        subtract(c[0], scale(back, v[0])), subtract(c[1], scale(back, v[1])),
        subtract(c[2], scale(back, v[2])), subtract(c[3], scale(back, v[3])),
    )  # fmt: skip


@inlined
def shape(triangle: bool, xi: float, eta: float) -> Weights:
    """N_i(xi, eta)."""
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
def beyond(triangle: bool, xi: float, eta: float) -> float:
    """How far outside the segment, in xi and eta of a quadrilateral (a side is 2 long); negative within."""
    if triangle:
        return 2.0 * max(-xi, -eta, xi + eta - 1.0)
    return max(abs(xi), abs(eta)) - 1.0


@inlined
def newton(
    xi: float, eta: float, a: Vector, b: Vector, w: Vector, d: Vector
) -> tuple[float, float, Vector, Vector, Vector, float]:
    """One step towards (p - r) . r,xi = (p - r) . r,eta = 0, and what it leaves, in xi and eta.

    `a`, `b`: r,xi and r,eta; `w`: r,xi,eta; `d`: p - r, there and at the end of the step. What a step ds leaves is of
    the order |r,xi,eta| / |r,xi| ds^2: nothing on a parallelogram. Steps are limited, so that a warped segment and a
    distant p do not throw the iteration off.
    """
    aa, bb, plain = dot(a, a), dot(b, b), dot(a, b)
    # The twist enters the Hessian of |p - r|^2 / 2 off the diagonal; where that is not convex, leave it out.
    ab = plain - dot(d, w)
    ab = plain if ab * ab >= 0.999 * aa * bb else ab
    ra, rb = dot(d, a), dot(d, b)
    inverse = 1.0 / (aa * bb - ab * ab)
    step_xi, step_eta = (bb * ra - ab * rb) * inverse, (aa * rb - ab * ra) * inverse
    longest = max(abs(step_xi), abs(step_eta))
    shorten = 2.0 / max(longest, 2.0)
    step_xi, step_eta = shorten * step_xi, shorten * step_eta
    b = add(b, scale(step_xi, w))
    d = subtract(d, add(scale(step_xi, a), scale(step_eta, b)))
    left = min(longest, longest * longest * (dot(w, w) / min(aa, bb)) ** 0.5)
    return xi + step_xi, eta + step_eta, add(a, scale(step_eta, w)), b, d, left if shorten == 1.0 else longest


@inlined
def project(triangle: bool, c: Corners, p: Vector, xi: float, eta: float) -> tuple[float, float]:
    """(xi, eta) with (p - r) . r,xi = (p - r) . r,eta = 0 by Newton's method from a first guess.

    They may lie outside the segment.
    """
    o, a, b, w = polynomial(triangle, c)
    a, b = add(a, scale(eta, w)), add(b, scale(xi, w))
    d = subtract(subtract(p, o), add(scale(xi, a), scale(eta, subtract(b, scale(xi, w)))))  # p - r
    for _ in range(ITERATIONS):
        xi, eta, a, b, d, left = newton(xi, eta, a, b, w, d)
        if left <= CONVERGED:
            break
    return xi, eta


@inlined
def border(triangle: bool, c: Corners, p: Vector) -> tuple[float, float]:
    """(xi, eta) of the point on the border that is closest to p."""
    best_xi, best_eta, least = 0.0, 0.0, np.inf
    for edge in range(3 if triangle else 4):
        if edge == 0:
            start, end = c[0], c[1]
        elif edge == 1:
            start, end = c[1], c[2]
        elif edge == 2:
            start, end = c[2], c[0] if triangle else c[3]
        else:
            start, end = c[3], c[0]
        along, to = subtract(end, start), subtract(p, start)
        s = min(max(dot(to, along) / dot(along, along), 0.0), 1.0)
        away = subtract(to, scale(s, along))
        if dot(away, away) < least:
            least = dot(away, away)
            best_xi, best_eta = on_edge(triangle, edge, s)
    return best_xi, best_eta


@inlined
def on_edge(triangle: bool, edge: int, s: float) -> tuple[float, float]:
    """(xi, eta) at the fraction s of an edge, from its first corner to the next."""
    if triangle:
        if edge == 0:
            return s, 0.0
        return (1.0 - s, s) if edge == 1 else (0.0, 1.0 - s)
    u = 2.0 * s - 1.0
    if edge == 0:
        return u, -1.0
    if edge == 1:
        return 1.0, u
    return (-u, 1.0) if edge == 2 else (-1.0, -u)


@inlined
def closest(triangle: bool, c: Corners, p: Vector, xi: float, eta: float) -> tuple[float, float, float]:
    """(xi, eta) of the closest point within the segment, and how far beyond it p projects (see `beyond`)."""
    xi, eta = project(triangle, c, p, xi, eta)
    out = beyond(triangle, xi, eta)
    if out > 0.0:
        xi, eta = border(triangle, c, p)
    return xi, eta, out
