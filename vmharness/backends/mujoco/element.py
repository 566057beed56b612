"""Elements of model.xml: their attributes, and the names by which they refer to each other."""

from xml.etree import ElementTree

import numpy as np
from numpy.typing import ArrayLike

from vmharness.backends.mujoco.model import Contact


def element(parent: ElementTree.Element, tag: str, **attributes: ArrayLike) -> ElementTree.Element:
    """Add an element; numbers are written with all their digits."""
    return ElementTree.SubElement(parent, tag, {name: _text(value) for name, value in attributes.items()})


def _text(value: ArrayLike) -> str:
    if isinstance(value, str):
        return value
    return " ".join(repr(float(number)) for number in np.atleast_1d(value))


def node_name(nid: int) -> str:
    """The site of a node, and the body of a mass."""
    return f"node{nid}"


def rigid_name(number: int) -> str:
    """A rigid body."""
    return f"rigid{number}"


def slide_name(nid: int, axis: int) -> str:
    """The slide joint of a mass along an axis."""
    return f"node{nid}{'xyz'[axis]}"


def tendon_name(eid: int) -> str:
    """A spring, damper or truss."""
    return f"element{eid}"


def plane_name(contact: Contact) -> str:
    """The plane of a contact."""
    return f"contact{contact.number}"


def touch_name(contact: Contact, nid: int) -> str:
    """What a mass touches a plane with: the sphere around it, or a tendon."""
    return f"contact{contact.number}node{nid}"
