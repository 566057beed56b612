"""Geometry of a bilinear segment r(xi, eta) = sum N_i x_i, N_i = (1 + xi_i xi)(1 + eta_i eta)/4."""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.compiled import kernel
from vmharness.explicit.state import Array

Index = NDArray[np.intp]

XI = (-1.0, 1.0, 1.0, -1.0)
ETA = (-1.0, -1.0, 1.0, 1.0)
ITERATIONS = 20
MAXPAR = 1.025  # a segment reaches this far in xi and eta, so that no node slips through between two


@kernel
def shape(i: int, xi: float, eta: float) -> float:
    """N_i(xi, eta)."""
    return 0.25 * (1.0 + XI[i] * xi) * (1.0 + ETA[i] * eta)


@kernel
def tangents(
    x: Array, corners: Index, xi: float, eta: float
) -> tuple[float, float, float, float, float, float]:
    """r,xi and r,eta."""
    a0, a1, a2, b0, b1, b2 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(4):
        c = corners[i]
        along_xi = 0.25 * XI[i] * (1.0 + ETA[i] * eta)
        along_eta = 0.25 * ETA[i] * (1.0 + XI[i] * xi)
        a0, a1, a2 = a0 + along_xi * x[c, 0], a1 + along_xi * x[c, 1], a2 + along_xi * x[c, 2]
        b0, b1, b2 = b0 + along_eta * x[c, 0], b1 + along_eta * x[c, 1], b2 + along_eta * x[c, 2]
    return a0, a1, a2, b0, b1, b2


@kernel
def normal(x: Array, corners: Index, xi: float, eta: float) -> tuple[float, float, float]:
    """The unit normal r,xi x r,eta / |...|."""
    a0, a1, a2, b0, b1, b2 = tangents(x, corners, xi, eta)
    n0, n1, n2 = a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0
    length = np.sqrt(n0 * n0 + n1 * n1 + n2 * n2)
    return n0 / length, n1 / length, n2 / length


@kernel
def offset(x: Array, corners: Index, p: Array, xi: float, eta: float) -> tuple[float, float, float]:
    """p - r(xi, eta)."""
    d0, d1, d2 = p[0], p[1], p[2]
    for i in range(4):
        weight = shape(i, xi, eta)
        c = corners[i]
        d0, d1, d2 = d0 - weight * x[c, 0], d1 - weight * x[c, 1], d2 - weight * x[c, 2]
    return d0, d1, d2


@kernel
def closest_point(x: Array, corners: Index, p: Array) -> tuple[float, float, float]:
    """(xi, eta) with (p - r) . r,xi = (p - r) . r,eta = 0 by Newton's method, and the distance of p to the segment.

    xi and eta may lie outside -1..1; the distance is to the closest point within. Steps are limited, so that a warped
    segment and a distant p do not throw the iteration off.
    """
    xi, eta = 0.0, 0.0
    for _ in range(ITERATIONS):
        a0, a1, a2, b0, b1, b2 = tangents(x, corners, xi, eta)
        d0, d1, d2 = offset(x, corners, p, xi, eta)
        # r,xi,eta is the twist of the segment; the Hessian of |p - r|^2 / 2 has it off the diagonal.
        w0, w1, w2 = 0.0, 0.0, 0.0
        for i in range(4):
            twist = 0.25 * XI[i] * ETA[i]
            c = corners[i]
            w0, w1, w2 = w0 + twist * x[c, 0], w1 + twist * x[c, 1], w2 + twist * x[c, 2]
        aa, bb = a0 * a0 + a1 * a1 + a2 * a2, b0 * b0 + b1 * b1 + b2 * b2
        ab = a0 * b0 + a1 * b1 + a2 * b2 - (d0 * w0 + d1 * w1 + d2 * w2)
        if ab * ab >= 0.999 * aa * bb:  # not convex here: leave the twist out (Gauss-Newton)
            ab = a0 * b0 + a1 * b1 + a2 * b2
        ra, rb = d0 * a0 + d1 * a1 + d2 * a2, d0 * b0 + d1 * b1 + d2 * b2
        determinant = aa * bb - ab * ab
        step_xi = (bb * ra - ab * rb) / determinant
        step_eta = (aa * rb - ab * ra) / determinant
        longest = max(abs(step_xi), abs(step_eta))
        if longest > 2.0:
            step_xi, step_eta = 2.0 * step_xi / longest, 2.0 * step_eta / longest
        xi, eta = xi + step_xi, eta + step_eta
        if longest < 1e-12:
            break
    inside_xi, inside_eta = min(max(xi, -1.0), 1.0), min(max(eta, -1.0), 1.0)
    d0, d1, d2 = offset(x, corners, p, inside_xi, inside_eta)
    return xi, eta, np.sqrt(d0 * d0 + d1 * d1 + d2 * d2)


@kernel
def nearest(x: Array, node: int, segments: Index, point: Array) -> int:
    """The segment nearest to `node`, if it projects on it, or -1; `point` receives xi, eta and the gap there.

    A node does not touch the segments that it is a corner of.
    """
    best, least, p = -1, np.inf, x[node]
    for s in range(segments.shape[0]):
        if node in segments[s]:
            continue
        xi, eta, distance = closest_point(x, segments[s], p)
        if distance < least:
            least = distance
            best = -1
            if abs(xi) <= MAXPAR and abs(eta) <= MAXPAR:
                best = s
                point[0], point[1] = xi, eta
    if best >= 0:
        point[2] = gap(x, segments[best], p, point[0], point[1])
    return best


@kernel
def gap(x: Array, corners: Index, p: Array, xi: float, eta: float) -> float:
    """(p - r(xi, eta)) . n, positive in front of the segment."""
    n0, n1, n2 = normal(x, corners, xi, eta)
    g = 0.0
    for i in range(4):
        weight = shape(i, xi, eta)
        c = corners[i]
        g += weight * ((p[0] - x[c, 0]) * n0 + (p[1] - x[c, 1]) * n1 + (p[2] - x[c, 2]) * n2)
    return g
