"""Springs, dampers and trusses as tendons; contacts as tendons, or as contacts of MuJoCo.

A contact without damping and friction is a tendon whose spring has a dead band, as wide as the gap: its force is that
of the penalty, k times the penetration. Others are contacts of a sphere around the mass with a plane. For the
penetration r, its velocity v, and the acceleration a_0 without contact, these have the acceleration

    a = (1 - d) a_0 + k_ref r + b_ref v

(MuJoCo's documentation, computation, constraint model). So k_ref = k/m and b_ref = c/m for d -> 0; solref has them with
the sign minus. d = 1e-4 is the least that MuJoCo allows: such a force begins with a jump of d m a_0. The tangential
velocity of a mass that sticks decreases at the rate GRIP/dt; the noslip solver lets it become zero.
"""

from xml.etree.ElementTree import Element

import numpy as np

from vmharness.backends.mujoco.element import (
    element,
    node_name,
    plane_name,
    slide_name,
    tendon_name,
    touch_name,
)
from vmharness.backends.mujoco.model import Contact, Model

IMPEDANCE = 1e-4  # d
GRIP = 0.1
ENDLESS = 1e30  # length of the other end of a dead band


def add_tendons(model: Model, parent: Element) -> None:
    """Add a tendon for each spring, damper and truss."""
    for tendon in model.tendons:
        spatial = element(
            parent,
            "spatial",
            name=tendon_name(tendon.eid),
            stiffness=tendon.stiffness,
            damping=tendon.damping,
            springlength=tendon.rest,
        )
        for row in tendon.ends:
            element(spatial, "site", site=node_name(model.id(row)))
    for contact in model.contacts:
        for row in contact.rows.tolist() if contact.spring else []:
            _gap_spring(model, parent, contact, row)


def _gap_spring(model: Model, parent: Element, contact: Contact, row: int) -> None:
    """A tendon whose length is the displacement of a mass toward the plane, and whose spring acts beyond the gap."""
    nid = model.id(row)
    gap = float((model.nodes.x0[row] - contact.origin) @ contact.normal)
    name, dead = touch_name(contact, nid), [-ENDLESS, gap]
    fixed = element(parent, "fixed", name=name, stiffness=contact.stiffness, springlength=dead)
    for axis in model.free(row):
        element(fixed, "joint", joint=slide_name(nid, axis), coef=-contact.normal[axis])


def add_contacts(model: Model, parent: Element, step: float) -> None:
    """Add a contact pair for each mass and its plane."""
    for contact in model.contacts:
        for row in [] if contact.spring else contact.rows.tolist():
            m, k = float(model.mass[row]), contact.stiffness
            c = contact.damping * 2.0 * np.sqrt(k * m)
            element(
                parent,
                "pair",
                geom1=plane_name(contact),
                geom2=touch_name(contact, model.id(row)),
                condim="3" if contact.friction else "1",
                solref=[-k / m, -c / m],
                solimp=[IMPEDANCE, IMPEDANCE, 1e-3, 0.5, 2.0],
                friction=[contact.friction, contact.friction, 0.0, 0.0, 0.0],
                solreffriction=[0.0, -IMPEDANCE * GRIP / step],
            )
