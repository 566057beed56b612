"""The stable step of springs and dampers.

Central differences with dashpots that lag half a step are stable while M - dt/2 C - dt^2/4 K is positive definite.
That holds for the whole if it holds for every element with its share of its nodes' masses. A node's mass is shared
by need, m_e = m q_e / sum q, where q = dt/2 c + dt^2/4 k is what each element needs; then for every element

    dt^2/4 W + dt/2 D <= 1        W = K_1/m_1 + K_2/m_2        D = C_1/m_1 + C_2/m_2

with K_i and C_i the sums of stiffness and damping over all discrete elements at node i. For a single element this is
the exact limit: 2 sqrt(m_1 m_2/((m_1 + m_2) k)) for a spring, 2 sqrt(m/k) to the ground,
(2/omega)(sqrt(1 + zeta^2) - zeta) for a spring with a damper beside it; for several it is on the safe side.

Bars, shells and solids need mass, too. An element whose own stable step is h needs the fraction (dt/h)^2 of its mass:
dt^2/4 K_e <= (dt/h)^2 M_e. The rest is left for springs and dampers, so that m_i above is

    m_i - dt^2 sum m_e/h_e^2

over the elements at the node, in the initial geometry (zero at rigid bodies, since the body has the mass). Neither
step alone is a bound: a bar of stiffness k with a spring of 2 k at its end has omega^2 = (2 + sqrt 2) k/m, where
either alone has 2 k/m.
"""

import numpy as np

from vmharness.explicit.state import Array, Index

HALVINGS = 60  # of the interval in which the step lies: to round-off


def stable_step(
    nodes: Index, stiffness: Array, damping: Array, mass: Array, taken: Array | None = None
) -> float:
    """The largest dt that satisfies the inequality above for all elements.

    `nodes` (ne, 2), -1 for the ground; `stiffness`, `damping` and `mass` (n,) of nodes; `taken` (n,): sum m_e/h_e^2.
    A node without mass is held (the model is refused otherwise) and counts as ground; one that has mass counts as
    free, held or not.
    """
    longest = _step_alone(nodes, stiffness, damping, mass)
    ends = nodes[nodes >= 0]
    if taken is None or not taken[ends].any() or np.isinf(longest):
        return longest
    shared = ends[taken[ends] > 0.0]
    longest = min(longest, float(np.sqrt(np.min(mass[shared] / taken[shared]))))
    low, high = 0.0, longest
    for _ in range(HALVINGS):
        dt = 0.5 * (low + high)
        if dt <= _step_alone(nodes, stiffness, damping, np.maximum(mass - dt**2 * taken, 0.0)):
            low = dt
        else:
            high = dt
    return low


def _step_alone(nodes: Index, stiffness: Array, damping: Array, mass: Array) -> float:
    """2/(D/2 + sqrt(D^2/4 + W))."""
    inverse = np.divide(1.0, mass, out=np.zeros_like(mass), where=mass > 0.0)
    moving = nodes >= 0
    W = np.sum((stiffness * inverse)[nodes], axis=1, where=moving)
    D = np.sum((damping * inverse)[nodes], axis=1, where=moving)
    rate = float(np.max(D / 2.0 + np.sqrt(D**2 / 4.0 + W)))
    return 2.0 / rate if rate > 0.0 else np.inf
