"""The step that the stiffness and the damping of a contact allow.

A contact is a spring k and a damper c between a node and a point of a segment, with M the masses of both. The damper
acts on v_{n-1/2} + dt/2 a_{n-1} (force.py). A motion that changes its sign in every step, x_{n+1} = -x_n, has
v_{n-1/2} = 2 x_n / dt and a_{n-1} = 4 x_n / dt^2, so that the damper sees 4 x_n / dt; the limit is

    dt^2 omega^2 + 4 dt gamma = 4      dt = 2 / (gamma + sqrt(gamma^2 + omega^2))

    omega^2 = k (1/m_node + 1/m_segment)      gamma = c (1/m_node + 1/m_segment)

With the fraction z of critical damping, gamma = 2 z omega, this is dt = 2/omega (sqrt(1 + 4 z^2) - 2 z). A node or
corner that is held has infinite mass. `longest_step` says it before the run, for a node at the corner of a segment, the
lightest that is not held; taken over all nodes and segments, not pairs,

    omega^2 <= max k_node / m_node + max k_segment / m_segment

which is at most twice too large where the two belong to different places. active_step.py says it for the contacts that
a run has, which add up. With SOFT = 1 the stiffness follows the step.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.contact import OneWay
from vmharness.explicit.state import Array


def longest_step(one: OneWay, mass: Array, held: NDArray[np.bool_]) -> float:
    """The longest stable step of a pass; `held` (n,) nodes do not move. Infinite where no node does."""
    inverse = np.divide(1.0, mass, out=np.zeros_like(mass), where=(mass > 0.0) & ~held)
    rows, corners = one.nodes["row"], one.segments["nodes"]
    if not (rows.size and corners.size):
        return np.inf
    k_node = np.minimum(one.nodes["penalty"], one.segments["penalty"].max())
    k_segment, lightest = one.segments["penalty"], inverse[corners].max(axis=1)
    node, segment = np.argmax(k_node * inverse[rows]), np.argmax(k_segment * lightest)
    square = k_node[node] * inverse[rows[node]] + k_segment[segment] * lightest[segment]
    corner = corners[segment][np.argmax(inverse[corners[segment]])]
    share = _damped_share(mass[rows[node]], mass[corner], inverse[rows[node]], inverse[corner])
    return limit(float(square), float(0.02 * one.parameters["vdc"][0] * share * np.sqrt(square)))


def limit(square: float, gamma: float) -> float:
    """2 / (gamma + sqrt(gamma^2 + omega^2)), infinite without stiffness; `square` is omega^2."""
    rate = gamma + (gamma * gamma + square) ** 0.5
    return 2.0 / rate if rate > 0.0 else np.inf


def _damped_share(node: float, segment: float, inverse_node: float, inverse_segment: float) -> float:
    """gamma / (2 z omega): the damper is that of the lesser mass, and acts on both where neither is held."""
    lesser = min(node, segment) if min(node, segment) > 0.0 else max(node, segment)
    return lesser * (inverse_node + inverse_segment)
