"""Channels of elements: springs, trusses and beams, shells, solids."""

import numpy as np

from vmharness.backends.calculix.dat import Array
from vmharness.backends.calculix.model import Member, Model
from vmharness.backends.calculix.plan import (
    NotReportedError,
    Plan,
    Printed,
    ends_of,
    joined,
    of_elements,
    of_nodes,
)
from vmharness.case.format import Channel
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.beam import SECTION_BEAM
from vmharness.deck.keywords.section.shell import SECTION_SHELL

TENSOR = ("xx", "yy", "zz", "xy", "xz", "yz")  # the order of job.dat
IN_PLANE = {"xx-stress": (0, 0), "yy-stress": (1, 1), "xy-stress": (0, 1)}
PLASTIC = "equivalent plastic strain"


def of_discrete(model: Model, channel: Channel) -> Plan:
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
    length, ends = model.length(*member.rows), ends_of(model, member)
    nodes = [of_nodes(ends, f"NODE{row + 1}", [row], "displacements") for row in member.rows]
    return joined(
        lambda printed: np.linalg.norm(ends(printed), axis=1) - length + offset, *nodes, start=offset
    )


def _alone(model: Model, row: int) -> bool:
    """Whether a node is held, and no element but one spring joins it: its reaction is the force of that."""
    joined = [name for (name, _), member in model.members.items() if row in member.rows]
    dampers = model.deck.all(MAT_DAMPER_VISCOUS)
    return joined == [ELEMENT_DISCRETE.name] and not dampers and bool(model.held[row, :3].all())


def _force(model: Model, member: Member, end: int, sign: float) -> Plan:
    """The force of the spring on a held end, along the line to the other: CalculiX prints none for a spring."""
    ends, name = ends_of(model, member), f"NODE{member.rows[end] + 1}"

    def value(printed: Printed) -> Array:
        along = ends(printed)
        along /= np.linalg.norm(along, axis=1)[:, None]
        return np.asarray(sign * (along * printed["forces", name][:, 0, 1:]).sum(axis=1))

    nodes = [of_nodes(ends, f"NODE{row + 1}", [row], "displacements") for row in member.rows]
    return joined(value, *nodes, of_nodes(value, name, [member.rows[end]], "forces"))


def of_beam(model: Model, channel: Channel) -> Plan:
    """The mean over the points of the solid to which a beam is expanded, along the line between its nodes."""
    member = model.members.get((ELEMENT_BEAM.name, channel.beam or 0))
    if member is None or channel.component not in ("axial-force", "axial-stress", "plastic-strain"):
        raise NotReportedError(f"calculix does not report {channel.component!r} of beam {channel.beam}")
    if channel.component == "plastic-strain":
        return _plastic(member)
    name, ends, factor = f"EL{member.number}", ends_of(model, member), member.stress
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

    nodes = [of_nodes(ends, f"NODE{row + 1}", [row], "displacements") for row in member.rows]
    return joined(value, *nodes, of_elements(value, name, [member.number], "S"), start=0.0)


def of_solid(model: Model, channel: Channel) -> Plan:
    """The mean over the points of a solid."""
    member = model.members.get((ELEMENT_SOLID.name, channel.solid or 0))
    component, _, quantity = str(channel.component).rpartition("-")
    if member is not None and channel.component == "plastic-strain":
        return _plastic(member)
    if member is None or quantity != "stress" or component not in TENSOR:
        raise NotReportedError(f"calculix does not report {channel.component!r} of solid {channel.solid}")
    name, column = f"EL{member.number}", 2 + TENSOR.index(component)
    one = of_elements(
        lambda printed: printed["stresses", name][:, :, column].mean(axis=1), name, [member.number], "S"
    )
    return joined(one.value, one, start=0.0)


def of_shell(model: Model, channel: Channel) -> Plan:
    """In-plane stress in the frame of the shell at the beginning: the mean of the four points of a layer.

    An S4 has its layers where Gauss's rule of two points has them; its first is the lower one.
    """
    member = model.members.get((ELEMENT_SHELL.name, channel.shell or 0))
    component, point = str(channel.component), channel.point or 1
    if member is None or component not in IN_PLANE or point > 2 or _points(model, channel.shell or 0) != 2:
        raise NotReportedError(
            f"calculix does not report {component!r} of shell {channel.shell}, point {point}"
        )
    frame = _frame(model.nodes.x0[list(member.rows)])
    first, second = (frame[axis] for axis in IN_PLANE[component])
    name, layer = f"EL{member.number}", slice(4 * point - 4, 4 * point)

    def value(printed: Printed) -> Array:
        xx, yy, zz, xy, xz, yz = printed["stresses", name][:, layer, 2:].mean(axis=1).T
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        return np.asarray(np.einsum("i,ijt,j->t", first, tensor, second))

    return joined(value, of_elements(value, name, [member.number], "S"), start=0.0)


def _points(model: Model, eid: int) -> int:
    """NIP of the section of a shell."""
    table = next(t for t in model.deck.all(ELEMENT_SHELL) if eid in t.eid)
    part = model.deck.find(PART, pid=int(table.pid[table.eid == eid][0]))
    return int(model.deck.find(SECTION_SHELL, secid=part.secid).nip)


def _frame(corners: Array) -> Array:
    """Unit vectors (3, 3) of a shell: along its first side, across it in the plane, and normal to it."""
    normal = np.cross(corners[2] - corners[0], corners[3] - corners[1])
    normal /= np.linalg.norm(normal)
    along = corners[1] - corners[0]
    along = along - (along @ normal) * normal
    along /= np.linalg.norm(along)
    return np.array([along, np.cross(normal, along), normal])


def _plastic(member: Member) -> Plan:
    name = f"EL{member.number}"
    one = of_elements(
        lambda printed: printed[PLASTIC, name][:, :, 2].mean(axis=1), name, [member.number], "PEEQ"
    )
    return joined(one.value, one, start=0.0)
