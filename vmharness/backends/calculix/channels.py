"""Channels: what CalculiX is to print for each, and how it follows from that."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from vmharness.backends.calculix.dat import Array, Key
from vmharness.backends.calculix.model import Member, Model
from vmharness.case.format import Channel
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.beam import SECTION_BEAM

Printed = Mapping[Key, Array]
AXES = {"x": 0, "y": 1, "z": 2}
TENSOR = ("xx", "yy", "zz", "xy", "xz", "yz")  # the order of job.dat
HEADS = {"displacements": "U", "velocities": "V", "forces": "RF", "stresses": "S"}
PLASTIC, INTERNAL, KINETIC = "equivalent plastic strain", "total internal energy", "total kinetic energy"


class NotReportedError(ValueError):
    """CalculiX, as it is driven here, does not give a quantity."""


@dataclass(frozen=True)
class Plan:
    """Sets (kind, name, members) and printed quantities (card, label) of a channel; its values (steps,) from them.

    `start` is its value at t = 0, at which CalculiX prints nothing; None where it is not known.
    """

    value: Callable[[Printed], Array]
    sets: frozenset[tuple[str, str, tuple[int, ...]]]
    printed: frozenset[tuple[str, str]]
    start: float | None = None


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


def _of_nodes(value: Callable[[Printed], Array], name: str, rows: list[int], *quantities: str) -> Plan:
    sets = {("NSET", name, tuple(row + 1 for row in rows))}
    printed = {(f"*NODE PRINT,NSET={name}", HEADS[quantity]) for quantity in quantities}
    return Plan(value, frozenset(sets), frozenset(printed))


def _of_elements(value: Callable[[Printed], Array], name: str, numbers: list[int], label: str) -> Plan:
    total = ",TOTALS=ONLY" if label in ("ELSE", "ELKE") else ""
    sets = {("ELSET", name, tuple(numbers))}
    return Plan(value, frozenset(sets), frozenset({(f"*EL PRINT,ELSET={name}{total}", label)}))


def _joined(value: Callable[[Printed], Array], *plans: Plan, start: float | None = None) -> Plan:
    sets, printed = (
        frozenset().union(*(getattr(one, what) for one in plans)) for what in ("sets", "printed")
    )
    return Plan(value, sets, printed, start)


def _split(channel: Channel, known: tuple[str, ...]) -> tuple[int, str]:
    """Axis and quantity of a component such as x-velocity."""
    axis, _, quantity = str(channel.component).partition("-")
    if axis not in AXES or quantity not in known:
        raise NotReportedError(f"calculix does not report {channel.component!r} of {channel.text!r}")
    return AXES[axis], quantity


def _of_node(model: Model, channel: Channel) -> Plan:
    axis, quantity = _split(channel, ("displacement", "coordinate", "velocity"))
    row = next((i for i, nid in enumerate(model.nodes.ids) if nid == channel.node), None)
    if row is None or not model.used[row]:
        raise NotReportedError(f"no node {channel.node} with a mass or an element")
    head = "velocities" if quantity == "velocity" else "displacements"
    base = float(model.nodes.x0[row, axis]) if quantity == "coordinate" else 0.0
    start = float(model.velocities[row, axis]) if quantity == "velocity" else base
    name = f"NODE{row + 1}"
    one = _of_nodes(lambda printed: base + printed[head, name][:, 0, 1 + axis], name, [row], head)
    return _joined(one.value, one, start=start)


def _of_discrete(model: Model, channel: Channel) -> Plan:
    member = model.members.get((ELEMENT_DISCRETE.name, channel.discrete or 0))
    if member is not None and channel.component == "elongation":
        return _elongation(model, channel, member)
    if member is not None and channel.component == "force":
        for end, sign in ((0, -1.0), (1, 1.0)):
            if _alone(model, member.rows[end]):
                return _force(model, member, end, sign)
    raise NotReportedError(f"calculix does not report {channel.component!r} of spring {channel.discrete}")


def _elongation(model: Model, channel: Channel, member: Member) -> Plan:
    tables = model.deck.all(ELEMENT_DISCRETE)
    offset = next(float(t.offset[t.eid == channel.discrete][0]) for t in tables if channel.discrete in t.eid)
    length, ends = model.length(*member.rows), _ends(model, member)
    nodes = [_of_nodes(ends, f"NODE{row + 1}", [row], "displacements") for row in member.rows]
    return _joined(
        lambda printed: np.linalg.norm(ends(printed), axis=1) - length + offset, *nodes, start=offset
    )


def _alone(model: Model, row: int) -> bool:
    """Whether a node is held, and no element but one spring joins it: its reaction is the force of that."""
    joined = [name for (name, _), member in model.members.items() if row in member.rows]
    dampers = model.deck.all(MAT_DAMPER_VISCOUS)
    return joined == [ELEMENT_DISCRETE.name] and not dampers and bool(model.held[row, :3].all())


def _force(model: Model, member: Member, end: int, sign: float) -> Plan:
    """The force of the spring on a held end, along the line to the other: CalculiX prints none for a spring."""
    ends, name = _ends(model, member), f"NODE{member.rows[end] + 1}"

    def value(printed: Printed) -> Array:
        along = ends(printed)
        along /= np.linalg.norm(along, axis=1)[:, None]
        return np.asarray(sign * (along * printed["forces", name][:, 0, 1:]).sum(axis=1))

    nodes = [_of_nodes(ends, f"NODE{row + 1}", [row], "displacements") for row in member.rows]
    return _joined(value, *nodes, _of_nodes(value, name, [member.rows[end]], "forces"))


def _ends(model: Model, member: Member) -> Callable[[Printed], Array]:
    """The vector (steps, 3) from the first node of an element to the second."""
    first, second = member.rows
    x0 = model.nodes.x0[second] - model.nodes.x0[first]

    def vector(printed: Printed) -> Array:
        u = [printed["displacements", f"NODE{row + 1}"][:, 0, 1:] for row in (first, second)]
        return np.asarray(x0 + u[1] - u[0])

    return vector


def _of_beam(model: Model, channel: Channel) -> Plan:
    """The mean over the points of the solid to which a beam is expanded, along the line between its nodes."""
    member = model.members.get((ELEMENT_BEAM.name, channel.beam or 0))
    if member is None or channel.component not in ("axial-force", "axial-stress", "plastic-strain"):
        raise NotReportedError(f"calculix does not report {channel.component!r} of beam {channel.beam}")
    if channel.component == "plastic-strain":
        return _plastic(member)
    name, ends, factor = f"EL{member.number}", _ends(model, member), member.stress
    if channel.component == "axial-force":
        table = next(t for t in model.deck.all(ELEMENT_BEAM) if channel.beam in t.eid)
        part = model.deck.find(PART, pid=int(table.pid[table.eid == channel.beam][0]))
        factor *= float(model.deck.find(SECTION_BEAM, secid=part.secid).a)

    def value(printed: Printed) -> Array:
        along = ends(printed)
        along /= np.linalg.norm(along, axis=1)[:, None]
        xx, yy, zz, xy, xz, yz = printed["stresses", name][:, :, 2:].mean(axis=1).T
        e = along.T
        normal = xx * e[0] ** 2 + yy * e[1] ** 2 + zz * e[2] ** 2
        return np.asarray(factor * (normal + 2.0 * (xy * e[0] * e[1] + xz * e[0] * e[2] + yz * e[1] * e[2])))

    nodes = [_of_nodes(ends, f"NODE{row + 1}", [row], "displacements") for row in member.rows]
    return _joined(value, *nodes, _of_elements(value, name, [member.number], "S"), start=0.0)


def _of_solid(model: Model, channel: Channel) -> Plan:
    """The mean over the points of a solid."""
    member = model.members.get((ELEMENT_SOLID.name, channel.solid or 0))
    component, _, quantity = str(channel.component).rpartition("-")
    if member is not None and channel.component == "plastic-strain":
        return _plastic(member)
    if member is None or quantity != "stress" or component not in TENSOR:
        raise NotReportedError(f"calculix does not report {channel.component!r} of solid {channel.solid}")
    name, column = f"EL{member.number}", 2 + TENSOR.index(component)
    one = _of_elements(
        lambda printed: printed["stresses", name][:, :, column].mean(axis=1), name, [member.number], "S"
    )
    return _joined(one.value, one, start=0.0)


def _plastic(member: Member) -> Plan:
    name = f"EL{member.number}"
    one = _of_elements(
        lambda printed: printed[PLASTIC, name][:, :, 2].mean(axis=1), name, [member.number], "PEEQ"
    )
    return _joined(one.value, one, start=0.0)


def _of_support(model: Model, channel: Channel) -> Plan:
    """Forces of the elements on held nodes, with the sign of the reaction; dampers are no part of them."""
    axis, _ = _split(channel, ("force",))
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
    return _of_nodes(
        lambda printed: printed["forces", name][:, :, 1 + axis].sum(axis=1), name, chosen + added, "forces"
    )


def _of_energy(model: Model, channel: Channel) -> Plan:
    known = energies(model)
    if channel.part is not None or channel.energy not in known:
        raise NotReportedError(f"calculix does not report the energy {channel.energy!r}")
    every = _of_elements(lambda printed: printed[INTERNAL, "EVERY"][:, 0, 0], "EVERY", _all(model), "ELSE")
    if channel.energy == "internal":
        return _joined(every.value, every, start=0.0)
    rows = np.flatnonzero(model.lumped).tolist()
    parts: list[Plan] = []
    if rows:
        mass = 0.5 * model.lumped[rows, None]
        parts.append(
            _of_nodes(
                lambda printed: (mass * printed["velocities", "LUMPED"][:, :, 1:] ** 2).sum(axis=(1, 2)),
                "LUMPED",
                rows,
                "velocities",
            )
        )
    if model.work:
        parts.append(
            _of_elements(lambda printed: printed[KINETIC, "EVERY"][:, 0, 0], "EVERY", _all(model), "ELKE")
        )
    return _joined(lambda printed: np.sum([one.value(printed) for one in parts], axis=0), *parts)


def _all(model: Model) -> list[int]:
    return [member.number for member in model.members.values()]


def _of_centre(model: Model, channel: Channel) -> Plan:
    """The mean of all nodes by their mass: with a consistent mass matrix, by the sums of its rows."""
    axis, quantity = _split(channel, ("displacement", "velocity", "momentum"))
    if channel.centre != "all":
        raise NotReportedError(f"calculix does not report {channel.component!r} of centre {channel.centre}")
    rows = np.flatnonzero(model.mass).tolist()
    share = model.mass[rows] / (1.0 if quantity == "momentum" else model.mass.sum())
    head = "displacements" if quantity == "displacement" else "velocities"
    start = 0.0 if quantity == "displacement" else float(share @ model.velocities[rows, axis])
    one = _of_nodes(lambda printed: printed[head, "HEAVY"][:, :, 1 + axis] @ share, "HEAVY", rows, head)
    return _joined(one.value, one, start=start)


OWNERS: dict[str, Callable[[Model, Channel], Plan]] = {
    "centre": _of_centre,
    "node": _of_node,
    "discrete": _of_discrete,
    "beam": _of_beam,
    "solid": _of_solid,
    "support": _of_support,
    "energy": _of_energy,
}
