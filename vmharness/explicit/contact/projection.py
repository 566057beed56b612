"""Closest point of a segment to a node.

Newton's method finds (xi, eta) with (p - r) . r,xi = (p - r) . r,eta = 0; where that lies outside the segment, the
closest point lies on its border.
"""

import numpy as np

from vmharness.explicit.contact.geometry import (
    Corners,
    beyond,
    centre,
    corners,
    interpolate,
    normal,
    polynomial,
    shape,
    start,
)
from vmharness.explicit.contact.records import Record
from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale, subtract, unit
from vmharness.explicit.state import Array

ITERATIONS = 20
CONVERGED = 1e-13  # in xi and eta


@inlined
def newton(
    xi: float, eta: float, a: Vector, b: Vector, w: Vector, d: Vector
) -> tuple[float, float, Vector, Vector, Vector, float]:
    """Take one Newton step to the projection; return the new xi, eta, r,xi, r,eta, p - r and the error left.

    `a`, `b`: r,xi and r,eta; `w`: r,xi,eta; `d`: p - r, there and at the end of the step. A step ds leaves an error in
    xi and eta of the order |r,xi,eta| / |r,xi| ds^2: none on a parallelogram. The length of a step is limited, so that
    the iteration does not diverge for a warped segment and a distant p.
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
    """(xi, eta) of the projection of p by Newton's method from a first guess; it may lie outside the segment."""
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
            first, second = c[0], c[1]
        elif edge == 1:
            first, second = c[1], c[2]
        elif edge == 2:
            first, second = c[2], c[0] if triangle else c[3]
        else:
            first, second = c[3], c[0]
        along, to = subtract(second, first), subtract(p, first)
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


@inlined
def project_node(
    x: Array, segment: Record, p: Vector, xi: float, eta: float
) -> tuple[float, float, float, Vector, Vector]:
    """Closest point xi, eta of a segment; how far beyond its border p projects; p - r and the normal there.

    (xi, eta) is the first guess.
    """
    c = corners(x, segment["nodes"])
    xi, eta, out = closest(segment["triangle"], c, p, xi, eta)
    a, b, _, away = start(segment["triangle"], c, p, xi, eta)
    return xi, eta, out, away, unit(cross(a, b))


@inlined
def height_over(
    triangle: bool, c: Corners, p: Vector, xi: float, eta: float
) -> tuple[float, float, float, Vector]:
    """xi, eta of the projection of p on the segment or its continuation; height of p over it; the normal there."""
    xi, eta = project(triangle, c, p, xi, eta)
    n = normal(triangle, c, xi, eta)
    return xi, eta, dot(subtract(p, interpolate(c, shape(triangle, xi, eta))), n), n


@inlined
def is_inside(out: float, tangent_square: float, away: Vector) -> bool:
    """Whether p, at `away` = p - r, is nearer to the segment than the border is, so that no neighbour is as near.

    `tangent_square` is the lesser of r,xi . r,xi and r,eta . r,eta.
    """
    return bool(out < 0.0 and out * out * tangent_square > dot(away, away))


@inlined
def midpoint(x: Array, segment: Record) -> Vector:
    """The point at the centre of a segment."""
    xi, eta = centre(segment["triangle"])
    return interpolate(corners(x, segment["nodes"]), shape(segment["triangle"], xi, eta))


@inlined
def half_thickness(node: Record, segment: Record) -> float:
    """The distance between mid-surfaces at which the surfaces touch, (t_node + t_segment)/2."""
    return float(0.5 * (node["thickness"] + segment["thickness"]))
