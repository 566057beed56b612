"""The mass that a rigid body opposes to springs and dampers at its nodes, for their stable step.

Masses m_k at the nodes are safe if no rigid motion has more kinetic energy with them than the body has,

    sum m_k |v + omega x r_k|^2 <= M v^2 + omega . I omega

for then the body only adds inertia to a model that is stable with these masses alone. They are shares of weights w_k,
m_k = w_k / lambda, with lambda the largest eigenvalue of the form of the weights against that of the body. For one node
this is its effective mass. Torsional springs take moments of inertia likewise; a body with both halves itself.

Contacts feel the mass that elements have lumped on the nodes of a body, which is safe as it is. Where mass and inertia
of the body are given, or a contact has nodes of it without mass, they feel shares: by the lumped mass as weight, and of
nodes without any by the mean of the others. A node of a body is never held, as one without mass is otherwise: the body
may be lighter than what it touches.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.elements.discrete.part import Discrete
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.bodies import Bodies


def bear(model: Model, bodies: Bodies) -> None:
    """Tell springs and dampers of the model which mass bodies have at their nodes."""
    discrete = [force for force in model.forces if isinstance(force, Discrete)]
    if not discrete:
        return
    weights = {force.about: _weights(force.demand)[bodies.nodes] for force in discrete}
    s = model.state
    found = {False: s.mass.copy(), True: s.inertia.copy()}
    for b in range(bodies.centre.size):
        own = slice(bodies.first[b], bodies.first[b + 1])
        kinds = [about for about, weight in weights.items() if weight[own].any()]
        for about in kinds:
            weight = weights[about][own]
            largest = (
                float(weight.sum() * bodies.inverse[b].max())
                if about
                else largest_ratio(s.mass[bodies.centre[b]], bodies.inverse[b], bodies.arm[own], weight)
            )
            found[about][bodies.nodes[own]] = weight / (largest * len(kinds))
    for force in discrete:
        force.bearing = found[force.about]


def share_given(model: Model, bodies: Bodies, given: list[bool]) -> None:
    """Put the shares of bodies on their nodes, as the lumped mass that contacts feel.

    Of bodies whose inertia is `given`, and of those with nodes without mass in a contact.
    """
    lumped, felt = model.state.lumped, _felt(model)
    for b in range(bodies.centre.size):
        own = slice(bodies.first[b], bodies.first[b + 1])
        nodes, mass = bodies.nodes[own], model.state.mass[bodies.centre[b]]
        bare = felt[nodes] & (lumped[nodes] == 0.0)
        if bare.any() or (given[b] and felt[nodes].any()):
            weight = lumped[nodes]
            weight[bare] = weight[weight > 0.0].mean() if weight.any() else 1.0
            lumped[nodes] = weight / largest_ratio(mass, bodies.inverse[b], bodies.arm[own], weight)


def _felt(model: Model) -> NDArray[np.bool_]:
    """Which nodes (n,) a contact has."""
    felt = np.zeros(model.ids.size, bool)
    for force in model.forces:
        if isinstance(force, Contact):
            felt[force.tracked] = felt[force.segments] = True
    return felt


def largest_ratio(mass: float, inverse: Array, arm: Array, weight: Array) -> float:
    """The largest sum w |v + omega x r|^2 over M v^2 + omega . I omega; `arm` (m, 3) in principal axes.

    `inverse` (3,): 1/I_i, zero about an axis that the body cannot turn about.

    >>> round(largest_ratio(2.0, np.array([1.0, 0.5, 0.5]), np.array([[1.0, 0.0, 0.0]]), np.ones(1)), 12)
    1.0
    """
    levers = np.zeros((len(arm), 3, 6))  # v and omega -> v_k = v - r x omega
    levers[:, :, :3] = np.eye(3)
    for i, (j, k) in enumerate(((1, 2), (2, 0), (0, 1))):
        levers[:, i, 3 + j], levers[:, i, 3 + k] = arm[:, k], -arm[:, j]
    levers *= np.sqrt(np.array([*[1.0 / mass] * 3, *inverse]))
    return float(np.linalg.eigvalsh(np.einsum("m,mia,mib->ab", weight, levers, levers))[-1])


def _weights(demand: Array) -> Array:
    """Stiffness and damping (2, n) that nodes are asked for, each as shares of its sum: weights (n,)."""
    total = demand.sum(axis=1, keepdims=True)
    return np.asarray((demand / np.where(total > 0.0, total, 1.0)).sum(axis=0))
