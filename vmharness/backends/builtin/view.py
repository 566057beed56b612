"""The model of a deck as it is drawn: elements, masses, supports, loads, contacts."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Keyword
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.constraints.spc import Supports
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.elements.discrete.part import Discrete
from vmharness.explicit.elements.mass import ELEMENT_MASS
from vmharness.explicit.elements.shell import shell_faces
from vmharness.explicit.loads.body import BodyLoad
from vmharness.explicit.loads.node import NodalLoad
from vmharness.explicit.loads.segment import Pressure
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.result import View


def view_of(deck: Deck, model: Model) -> View:
    """The model before its nodes move."""
    discrete = [force.nodes for force in model.forces if isinstance(force, Discrete)]
    masses = [model.find(table, "nid", table.nid) for table in deck.all(ELEMENT_MASS)]
    count, fixed = model.node_count, np.zeros(model.ids.size, bool)
    for constraint in model.constraints:
        if isinstance(constraint, Supports):
            fixed |= constraint.fixed.any(axis=1)
    gravity = np.zeros(3)
    for force in model.forces:
        if isinstance(force, BodyLoad):
            gravity[force.axis] += force.acceleration
    return View(
        ids=model.ids[:count],
        x=model.x0[:count],
        shells=shell_faces(deck, model),
        solids=_corners(deck, model, 8, ELEMENT_SOLID),
        beams=_corners(deck, model, 2, ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION),
        discrete=_between_nodes(discrete),
        masses=np.concatenate(masses) if masses else np.zeros(0, np.intp),
        supports=np.flatnonzero(fixed[:count]),
        gravity=gravity,
        contacts=tuple(
            (force.tracked, force.segments) for force in model.forces if isinstance(force, Contact)
        ),
        arrows=_arrows(model),
    )


def _corners(deck: Deck, model: Model, corners: int, *keywords: Keyword) -> NDArray[np.intp]:
    """Rows of the nodes of all elements (ne, corners) of these keywords."""
    tables = [model.corners(table, table.keyword.corners) for table in deck.all(*keywords)]
    return np.concatenate([*tables, np.zeros((0, corners), np.intp)])


def _arrows(model: Model) -> dict[str, tuple[Array, Array]]:
    """Where forces, pressures and prescribed motions act, and which way at their largest."""
    found: dict[str, list[tuple[Array, Array]]] = {"force": [], "pressure": [], "motion": []}
    for force in model.forces:
        if isinstance(force, NodalLoad):
            moves = force.dofs < 3
            value = np.sign(force.scale * force.curve.largest())[moves, None]
            found["force"].append((model.x0[force.nodes[moves]], value * np.eye(3)[force.dofs[moves]]))
        elif isinstance(force, Pressure):
            corners = model.x0[force.faces]
            normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
            value = -np.sign(force.factor * force.curve.largest()) / np.linalg.norm(normal, axis=1)
            found["pressure"].append((corners.mean(axis=1), value[:, None] * normal))
    for motion in model.constraints:
        if isinstance(motion, PrescribedMotion) and motion.dof < 3:
            value = np.sign(motion.sf * motion.curve.largest())
            along = np.tile(value * np.eye(3)[motion.dof], (motion.nodes.size, 1))
            found["motion"].append((model.x0[motion.nodes], along))
    return {
        what: (np.concatenate([at for at, _ in arrows]), np.concatenate([along for _, along in arrows]))
        for what, arrows in found.items()
        if arrows
    }


def _between_nodes(discrete: list[NDArray[np.intp]]) -> NDArray[np.intp]:
    """The nodes (ne, 2) of all springs and dampers but those to the ground."""
    nodes = np.concatenate([*discrete, np.zeros((0, 2), np.intp)])
    return nodes[nodes[:, 1] >= 0]
