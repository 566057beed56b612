"""The step that the active contacts of a model allow: those at one node add up, of all contacts of the deck.

A contact with the weights g, 1 at the node and -N_i at the corners of the segment, has the stiffness k g g^T along its
normal, and in friction across it too. With M^-1 = diag(1/m_i), the eigenvalues of M^-1 sum k g g^T are not above

    omega^2 = max over nodes i of sum over contacts k |g_i| s      s = sum_j |g_j| / m_j

(Gershgorin's theorem, scaled by the masses), exact for a node at the corner of one segment; gamma with c for k.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vmharness.explicit.contact.contact import Contact, OneWay
from vmharness.explicit.contact.force import add_pair, damping_coefficient, stiffness
from vmharness.explicit.contact.geometry import Weights, shape
from vmharness.explicit.contact.kinematics import relative
from vmharness.explicit.contact.records import Record, Records, vector_of
from vmharness.explicit.contact.stable_step import limit
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import dot, inlined, scale
from vmharness.explicit.state import Array, State


class Active(NamedTuple):
    """A limit by active contacts: dt, omega^2 and gamma at the row of the node that has it."""

    dt: float
    square: float
    gamma: float
    row: int


def active_step(contacts: Sequence[Contact], mass: Array, inverse: Array) -> Active:
    """The longest stable step of all active contacts, infinite without; `inverse` (n,) is 0 where a node is held."""
    square, gamma = np.zeros(mass.size), np.zeros(mass.size)
    for contact in contacts:
        for one in contact.passes:
            add_rates(one.segments, one.nodes, one.states, one.parameters, mass, inverse, square, gamma)
    free = inverse > 0.0
    square, gamma = square * free, gamma * free
    row = int(np.argmax(gamma + np.sqrt(gamma * gamma + square)))
    return Active(limit(float(square[row]), float(gamma[row])), float(square[row]), float(gamma[row]), row)


class Linearised:
    """The active contacts of a pass as springs and dampers that neither begin nor end."""

    name = "contact"

    def __init__(self, one: OneWay, mass: Array) -> None:
        self.one, self.mass, self.energy = one, mass, dict[str, Array]()

    def linearised(self) -> "Linearised":
        """Itself: it is linear."""
        return self

    def add(self, state: State) -> None:
        """Add the forces of a small step of the velocity v: -(k dt + 4 c) v, as stable_step.py counts dampers."""
        one = self.one
        add_small_forces(
            one.segments, one.nodes, one.states, one.parameters, self.mass, state.v, state.dt, state.f
        )


@inlined
def coefficients(
    parameters: Record, node: Record, segment: Record, weights: Weights, mass: Array
) -> tuple[float, float]:
    """k and c of a contact."""
    nodes, m_m = segment["nodes"], 0.0
    for i in range(4):
        m_m += weights[i] * mass[nodes[i]]
    k = stiffness(node, segment, mass, parameters["sofscl"], parameters["longest_step"])
    return k, damping_coefficient(parameters["vdc"], k, mass[node["row"]], m_m)


@kernel
def add_rates(
    segments: Records, nodes: Records, states: Records, pass_parameters: Records, mass: Array, inverse: Array,
    # updated
    square: Array, gamma: Array,
) -> None:  # fmt: skip
    """Add the sums of k |g_i| s and c |g_i| s to the nodes (n,)."""
    for t in range(nodes.size):
        for place in range(nodes[t]["count"]):
            state, row = states[place, t], nodes[t]["row"]
            segment = segments[state["segment"]]
            weights = shape(segment["triangle"], state["xi"], state["eta"])
            k, c = coefficients(pass_parameters[0], nodes[t], segment, weights, mass)
            total = inverse[row]
            for i in range(4):
                total += abs(weights[i]) * inverse[segment["nodes"][i]]
            square[row] += k * total
            gamma[row] += c * total
            for i in range(4):
                square[segment["nodes"][i]] += abs(weights[i]) * k * total
                gamma[segment["nodes"][i]] += abs(weights[i]) * c * total


@kernel
def add_small_forces(
    segments: Records, nodes: Records, states: Records, pass_parameters: Records, mass: Array, v: Array, dt: float,
    # updated
    f: Array,
) -> None:  # fmt: skip
    """Add the forces of the active contacts; with friction a contact is as stiff across its normal."""
    for t in range(nodes.size):
        for place in range(nodes[t]["count"]):
            state, row = states[place, t], nodes[t]["row"]
            segment, n = segments[state["segment"]], vector_of(state["normal"])
            weights = shape(segment["triangle"], state["xi"], state["eta"])
            k, c = coefficients(pass_parameters[0], nodes[t], segment, weights, mass)
            moved = relative(v, row, segment, weights)
            along = dot(moved, n)
            across = k * dt if pass_parameters[0]["friction"] else 0.0
            force = scale(-(k * dt + 4.0 * c - across) * along, n)
            add_pair(f, row, segment, weights, force)
            add_pair(f, row, segment, weights, scale(-across, moved))
