"""Forces and energies of a contact."""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes._quantity import AXES, Probe, ProbeError, choose


def of_contact(model: Model, contact: int, component: str, node: int | None = None) -> Probe:
    """A component of a contact: `z-force`, `energy`, `friction energy`, `released energy`, `area`, `nodes`.

    The force is the resultant on surface A. `energy` is that of penalty springs and their damping, `released energy`
    that of springs that were removed while compressed; `area` and `nodes` are those of the nodes in contact. With
    `node`, the force is that on this tracked node, without forces on it as a corner of segments.
    """
    contacts = {force.number: force for force in model.forces if isinstance(force, Contact)}
    if contact not in contacts:
        raise ProbeError(f"no contact {contact}; there are: {', '.join(map(str, contacts)) or 'none'}")
    found = contacts[contact]
    if node is not None:
        return _on_node(model, found, node, component)
    probes: dict[str, Probe] = {
        **{f"{axis}-force": found.force[i : i + 1].item for axis, i in AXES.items()},
        "energy": found.energy["contact"].item,
        "friction energy": found.energy["friction"].item,
        "released energy": found.energy["released"].item,
        "area": found.area,
        "nodes": found.nodes_in_contact,
    }
    return choose(probes, component, "of a contact")


def _on_node(model: Model, found: Contact, node: int, component: str) -> Probe:
    places = np.flatnonzero(model.ids[found.tracked] == node)
    if not places.size:
        raise ProbeError(f"no node {node} among the tracked nodes of contact {found.number}")
    probes = {f"{axis}-force": _summed(found, places, i) for axis, i in AXES.items()}
    return choose(probes, component, "on a node in contact")


def _summed(found: Contact, places: NDArray[np.intp], axis: int) -> Probe:
    """The sum of the forces on a node that is tracked once, or on both sides of a surface."""
    return lambda: float(found.forces[places, axis].sum())


PROBES = {"contact": of_contact}
