"""Channels as sums of what MuJoCo gives: a constant, and terms (function, name of an object, index, factor)."""

from vmharness.backends._translation.review import NotReportedError
from vmharness.backends.mujoco.element import node_name, rigid_name, tendon_name, touch_name
from vmharness.backends.mujoco.model import Model
from vmharness.case.format import Channel

Term = tuple[str, str, int, float]
Sum = tuple[float, list[Term]]

AXES = ("x", "y", "z")


def terms(model: Model, channel: Channel) -> Sum:
    """The channel as a sum; raises NotReportedError."""
    for owner, make in OWNERS.items():
        if getattr(channel, owner) is not None:
            axis, _, quantity = str(channel.component).partition("-")
            found = make(model, channel, AXES.index(axis) if axis in AXES else -1, quantity)
            if found is not None:
                return found
            what = channel.component or channel.energy
            raise NotReportedError(f"mujoco does not report {what!r} of {owner} {getattr(channel, owner)}")
    raise NotReportedError(f"mujoco does not report {channel.text!r}")


def _of_node(model: Model, channel: Channel, axis: int, quantity: str) -> Sum | None:
    rows = [row for row, nid in enumerate(model.nodes.ids) if nid == channel.node]
    if not rows or not (model.used[rows[0]] or rows[0] in model.owner):
        raise NotReportedError(f"no node {channel.node} with a mass, a spring or a rigid body")
    return _motion(
        "site", node_name(int(channel.node or 0)), float(model.nodes.x0[rows[0], axis]), axis, quantity
    )


def _of_rigid(model: Model, channel: Channel, axis: int, quantity: str) -> Sum | None:
    body = model.bodies.get(channel.rigid or 0)
    if body is None or body.fixed or axis < 0:
        return None
    name = rigid_name(body.number)
    if quantity in ("angular-velocity", "angular-momentum"):
        return 0.0, [(f"body {quantity}", name, axis, 1.0)]
    return _motion("body", name, float(body.centre[axis]), axis, quantity)


def _motion(kind: str, name: str, start: float, axis: int, quantity: str) -> Sum | None:
    if axis < 0 or quantity not in ("coordinate", "displacement", "velocity"):
        return None
    function = "velocity" if quantity == "velocity" else "position"
    return (-start if quantity == "displacement" else 0.0), [(f"{kind} {function}", name, axis, 1.0)]


def _of_joint(model: Model, channel: Channel, axis: int, quantity: str) -> Sum | None:
    """The force on the body of the first node: that of the parent on the child, or its opposite."""
    if quantity != "force" or axis < 0 or not 1 <= (channel.joint or 0) <= len(model.joints):
        return None
    child, sign = model.joints[(channel.joint or 0) - 1]
    return 0.0, [("joint force", rigid_name(child), axis, sign)]


def _of_contact(model: Model, channel: Channel, axis: int, quantity: str) -> Sum | None:
    """The force on the masses, or on that of one node."""
    for contact in model.contacts:
        if contact.number == channel.contact and quantity == "force" and axis >= 0:
            names = [
                touch_name(contact, nid)
                for nid in model.nodes.ids[contact.rows]
                if channel.node in (None, nid)
            ]
            if contact.spring:
                return 0.0, [("gap force", name, 0, float(contact.normal[axis])) for name in names]
            return 0.0, [("contact force", name, axis, 1.0) for name in names]
    return None


def _of_discrete(model: Model, channel: Channel, axis: int, quantity: str) -> Sum | None:
    for tendon in model.tendons:
        if tendon.eid == channel.discrete and channel.component in ("force", "elongation"):
            start = 0.0 if channel.component == "force" else -tendon.rest
            return start, [(f"tendon {channel.component}", tendon_name(tendon.eid), 0, 1.0)]
    return None


def _of_energy(model: Model, channel: Channel, axis: int, quantity: str) -> Sum | None:
    """The kinetic energy, and the internal energy: that of springs, if no spring is a contact."""
    given = ("kinetic",) if model.contacts else ("kinetic", "internal")
    if channel.energy not in given or channel.part is not None:
        return None
    return 0.0, [(f"{channel.energy} energy", "", 0, 1.0)]


OWNERS = {
    "contact": _of_contact,
    "node": _of_node,
    "rigid": _of_rigid,
    "joint": _of_joint,
    "discrete": _of_discrete,
    "energy": _of_energy,
}
