"""Channels of nodes, supports, energies and the centre of mass, and the choice among all channels."""

from collections.abc import Callable

import numpy as np

from vmharness.backends._translation.review import NotReportedError
from vmharness.backends.calculix.elements import of_beam, of_discrete, of_shell, of_solid
from vmharness.backends.calculix.model import Model
from vmharness.backends.calculix.plan import Plan, joined, of_elements, of_nodes, split
from vmharness.case.format import Channel
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS

INTERNAL, KINETIC = "total internal energy", "total kinetic energy"


def plan(model: Model, channel: Channel) -> Plan:
    """How the channel is had; raises NotReportedError."""
    for owner, make in OWNERS.items():
        if getattr(channel, owner) is not None and (owner != "node" or channel.contact is None):
            return make(model, channel)
    raise NotReportedError(f"calculix does not report {channel.text!r}")


def energies(model: Model) -> dict[str, Channel]:
    """The energies that it records of a model."""
    kept = ("kinetic",) if model.preloaded else ("kinetic", "internal")
    return {name: Channel(text=name, energy=name) for name in kept}


def _of_node(model: Model, channel: Channel) -> Plan:
    axis, quantity = split(channel, ("displacement", "coordinate", "velocity"))
    row = next((i for i, nid in enumerate(model.nodes.ids) if nid == channel.node), None)
    if row is None or not model.used[row]:
        raise NotReportedError(f"no node {channel.node} with a mass or an element")
    head = "velocities" if quantity == "velocity" else "displacements"
    base = float(model.nodes.x0[row, axis]) if quantity == "coordinate" else 0.0
    start = float(model.velocities[row, axis]) if quantity == "velocity" else base
    name = f"NODE{row + 1}"
    one = of_nodes(lambda printed: base + printed[head, name][:, 0, 1 + axis], name, [row], head)
    return joined(one.value, one, start=start)


def _of_support(model: Model, channel: Channel) -> Plan:
    """Forces of the elements on held nodes, with the sign of the reaction; dampers are no part of them."""
    axis, _ = split(channel, ("force",))
    held = model.held[:, axis] & model.used
    chosen = [
        row for row in np.flatnonzero(held).tolist() if channel.support in ("all", model.nodes.ids[row])
    ]
    if not chosen or model.deck.all(MAT_DAMPER_VISCOUS):
        raise NotReportedError("calculix does not report the forces of dampers on supports")
    added = [
        number - 1 for row in chosen for found in model.corners.get(row, {}).values() for number in found
    ]
    name = f"SUPPORT{channel.support}{'XYZ'[axis]}".upper()
    return of_nodes(
        lambda printed: printed["forces", name][:, :, 1 + axis].sum(axis=1), name, chosen + added, "forces"
    )


def _of_energy(model: Model, channel: Channel) -> Plan:
    known = energies(model)
    if channel.part is not None or channel.energy not in known:
        raise NotReportedError(f"calculix does not report the energy {channel.energy!r}")
    every = of_elements(lambda printed: printed[INTERNAL, "EVERY"][:, 0, 0], "EVERY", _all(model), "ELSE")
    if channel.energy == "internal":
        return joined(every.value, every, start=0.0)
    rows = np.flatnonzero(model.lumped).tolist()
    parts: list[Plan] = []
    if rows:
        mass = 0.5 * model.lumped[rows, None]
        parts.append(
            of_nodes(
                lambda printed: (mass * printed["velocities", "LUMPED"][:, :, 1:] ** 2).sum(axis=(1, 2)),
                "LUMPED",
                rows,
                "velocities",
            )
        )
    if model.work:
        parts.append(
            of_elements(lambda printed: printed[KINETIC, "EVERY"][:, 0, 0], "EVERY", _all(model), "ELKE")
        )
    return joined(lambda printed: np.sum([one.value(printed) for one in parts], axis=0), *parts)


def _all(model: Model) -> list[int]:
    return [member.number for member in model.members.values()]


def _of_centre(model: Model, channel: Channel) -> Plan:
    """The mean of all nodes by their mass: with a consistent mass matrix, by the sums of its rows."""
    axis, quantity = split(channel, ("displacement", "velocity", "momentum"))
    if channel.centre != "all":
        raise NotReportedError(f"calculix does not report {channel.component!r} of centre {channel.centre}")
    rows = np.flatnonzero(model.mass).tolist()
    share = model.mass[rows] / (1.0 if quantity == "momentum" else model.mass.sum())
    head = "displacements" if quantity == "displacement" else "velocities"
    start = 0.0 if quantity == "displacement" else float(share @ model.velocities[rows, axis])
    one = of_nodes(lambda printed: printed[head, "HEAVY"][:, :, 1 + axis] @ share, "HEAVY", rows, head)
    return joined(one.value, one, start=start)


OWNERS: dict[str, Callable[[Model, Channel], Plan]] = {
    "centre": _of_centre,
    "node": _of_node,
    "discrete": of_discrete,
    "beam": of_beam,
    "solid": of_solid,
    "shell": of_shell,
    "support": _of_support,
    "energy": _of_energy,
}
