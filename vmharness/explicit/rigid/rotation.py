"""Rotations as unit quaternions (s, u): a turn by theta about u has s = cos(theta/2), |u| = sin(theta/2)."""

import math

from vmharness.explicit.kernels.rotation import Triad, triad, turned
from vmharness.explicit.kernels.vector import Vector, dot, inlined, scale
from vmharness.explicit.model.state import Array

SMALL = 5e-3  # below it the series of tan is exact to round-off


@inlined
def rodrigues(w: Vector) -> Vector:
    """The Rodrigues vector tan(theta/2) n of the rotation vector w = theta n."""
    square = dot(w, w)
    if square < SMALL * SMALL:
        return scale(0.5 + square / 24.0 + square * square / 240.0, w)
    theta = math.sqrt(square)
    return scale(math.tan(0.5 * theta) / theta, w)


@inlined
def frame(q: Array, w: Vector) -> Triad:
    """The axes in space of the frame `q` (4,), turned further by the rotation vector w."""
    s, u = turned(q[0], (q[1], q[2], q[3]), rodrigues(w))
    return triad(s, u)


@inlined
def turn(q: Array, w: Vector) -> None:
    """Turn the frame `q` (4,) by the rotation vector w; its norm is kept at 1."""
    s, u = turned(q[0], (q[1], q[2], q[3]), rodrigues(w))
    norm = 1.0 / math.sqrt(s * s + dot(u, u))
    q[0], q[1], q[2], q[3] = norm * s, norm * u[0], norm * u[1], norm * u[2]
