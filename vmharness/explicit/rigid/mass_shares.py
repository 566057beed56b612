"""The mass of a rigid body, shared among its nodes: what springs, dampers and contacts at the nodes feel.

Masses m_k at the nodes are safe for the stable step if no rigid motion has more kinetic energy with them than with the
mass M and the inertia I of the body,

    sum m_k |v + omega x r_k|^2 <= M v^2 + omega . I omega

for then the body only adds inertia to a model that is stable with these masses. They are proportional to weights w_k,
m_k = w_k / lambda, with lambda the largest eigenvalue of the quadratic form of the weights relative to that of the
body. For one node m_k is its effective mass. Moments of inertia are shared likewise among torsional springs; a body
with springs of both kinds gives each kind half of its inertia.

Contacts feel the mass that elements have lumped at the nodes of a body, which is safe. Where mass and inertia of a body
are given by cards, or a contact has nodes of it without mass, contacts feel shares with the lumped mass as weights, and
the mean of these as the weight of nodes without mass. A node of a body never counts as held, as other nodes without
mass do: the body may be lighter than what it touches.
"""

import numpy as np

from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.elements.discrete.part import Discrete
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.state import Array, Flags


def share_body_mass(model: Model, bodies: Bodies) -> None:
    """Set the mass, or rotary inertia, that bodies have at the nodes of springs and dampers."""
    discrete = [force for force in model.forces if isinstance(force, Discrete)]
    if not discrete:
        return
    weights = {force.about: _weights(force.demand)[bodies.nodes] for force in discrete}
    s = model.state
    found = {False: s.mass.copy(), True: s.inertia.copy()}
    for b, own in enumerate(bodies.slices()):
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


def share_lumped_mass(model: Model, bodies: Bodies, inertia_given: list[bool]) -> None:
    """Set the lumped mass that contacts feel at the nodes of bodies whose own lumped mass will not do.

    These are bodies whose inertia is given by cards, and bodies with nodes without mass in a contact.
    """
    lumped, touched = model.state.lumped, _nodes_of_contacts(model)
    for b, own in enumerate(bodies.slices()):
        nodes, mass = bodies.nodes[own], model.state.mass[bodies.centre[b]]
        bare = touched[nodes] & (lumped[nodes] == 0.0)
        if bare.any() or (inertia_given[b] and touched[nodes].any()):
            weight = lumped[nodes]
            weight[bare] = weight[weight > 0.0].mean() if weight.any() else 1.0
            lumped[nodes] = weight / largest_ratio(mass, bodies.inverse[b], bodies.arm[own], weight)


def _nodes_of_contacts(model: Model) -> Flags:
    """Which nodes (n,) a contact has."""
    found = np.zeros(model.ids.size, bool)
    for force in model.forces:
        if isinstance(force, Contact):
            found[force.tracked] = found[force.segments] = True
    return found


def largest_ratio(mass: float, inverse: Array, arm: Array, weight: Array) -> float:
    """The largest value of sum w |v + omega x r|^2 / (M v^2 + omega . I omega); `arm` (m, 3) in principal axes.

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
    """Weights (n,) of the nodes: the shares that each has of the sum of stiffness and of damping, `demand` (2, n)."""
    total = demand.sum(axis=1, keepdims=True)
    return np.asarray((demand / np.where(total > 0.0, total, 1.0)).sum(axis=0))
