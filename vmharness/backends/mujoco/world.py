"""Masses, rigid bodies, held nodes and planes as bodies of MuJoCo."""

from xml.etree.ElementTree import Element

import numpy as np

from vmharness.backends.mujoco.element import (
    element,
    node_name,
    plane_name,
    rigid_name,
    slide_name,
    touch_name,
)
from vmharness.backends.mujoco.model import Body, Contact, Model
from vmharness.mesh.nodes import Array

RADIUS = 1e-3  # of the spheres around masses, as a fraction of the size of the surface that they touch


def add_bodies(model: Model, world: Element) -> list[float]:
    """Add all bodies; their velocities at t = 0, in the order of their joints."""
    velocities: list[float] = []
    for contact in model.contacts:
        if not contact.spring:
            _plane(contact, world)
    for row in np.flatnonzero(model.used).tolist():
        if row not in model.owner and not model.moves(row):
            _site(model, world, row, np.zeros(3))
    for body in model.bodies.values():
        if body.fixed:
            for row in body.rows.tolist():
                _site(model, world, row, np.zeros(3))
        elif body.joint is None or body.joint.parent is None:
            _rigid(model, world, body, np.zeros(3), velocities)
    for row in np.flatnonzero(model.used).tolist():
        if model.moves(row):
            _mass(model, world, row, velocities)
    return velocities


def _site(model: Model, parent: Element, row: int, origin: Array) -> None:
    element(parent, "site", name=node_name(model.id(row)), pos=model.nodes.x0[row] - origin)


def _mass(model: Model, world: Element, row: int, velocities: list[float]) -> None:
    """A mass on slide joints along the axes in which it is free; it does not turn, so its inertia has no effect."""
    nid, mass = model.id(row), float(model.mass[row])
    body = element(world, "body", name=node_name(nid), pos=model.nodes.x0[row])
    element(body, "inertial", pos=np.zeros(3), mass=mass, diaginertia=np.full(3, mass))
    damping = float(model.drag[row]) * mass
    for axis in model.free(row):
        element(
            body, "joint", name=slide_name(nid, axis), type="slide", axis=np.eye(3)[axis], damping=damping
        )
        velocities.append(float(model.v[row, axis]))
    element(body, "site", name=node_name(nid))
    for contact in model.contacts:
        if row in contact.rows and not contact.spring:
            name, size = touch_name(contact, nid), RADIUS * contact.size
            element(body, "geom", name=name, type="sphere", size=size, contype="0", conaffinity="0")


def _rigid(model: Model, parent: Element, body: Body, origin: Array, velocities: list[float]) -> None:
    """A rigid body with its nodes, and the bodies that hang on it; its axes are the global ones at t = 0."""
    own = element(parent, "body", name=rigid_name(body.number), pos=body.centre - origin)
    tensor = body.tensor[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]  # xx, yy, zz, xy, xz, yz
    element(own, "inertial", pos=np.zeros(3), mass=body.mass, fullinertia=tensor)
    velocities += _joint(own, body)
    for row in body.rows.tolist():
        _site(model, own, row, body.centre)
    for child in model.bodies.values():
        if child.joint is not None and child.joint.parent is body:
            _rigid(model, own, child, body.centre, velocities)


def _joint(own: Element, body: Body) -> list[float]:
    """Add the joint of a rigid body to its parent; the velocities of its degrees of freedom."""
    joint = body.joint
    if joint is None:
        element(own, "freejoint")
        return [*body.v.tolist(), *body.omega.tolist()]
    spin = body.omega if joint.parent is None else body.omega - joint.parent.omega
    anchor = joint.anchor - body.centre
    if joint.axis is None:
        element(own, "joint", type="ball", pos=anchor)
        return list(spin.tolist())
    element(own, "joint", type="hinge", pos=anchor, axis=joint.axis)
    return [float(spin @ joint.axis)]


def _plane(contact: Contact, world: Element) -> None:
    """The plane lies one radius of the spheres behind the surface, so that a sphere touches it when its centre does."""
    radius = RADIUS * contact.size
    element(
        world,
        "geom",
        name=plane_name(contact),
        type="plane",
        size=[contact.size, contact.size, radius],
        pos=contact.origin - radius * contact.normal,
        zaxis=contact.normal,
        contype="0",
        conaffinity="0",
    )
