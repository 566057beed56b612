"""Combinations of rigid bodies with supports, motions, loads, damping and mass scaling that are not supported."""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.damping.mass import MassDamping
from vmharness.explicit.loads.body import BodyLoad, Centrifugal
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.body import RigidBody
from vmharness.explicit.rigid.joint_cards import joint_entries
from vmharness.explicit.state import Array
from vmharness.explicit.timestep.mass_scaling import MassScaling


def check_constraints(model: Model, bodies: list[RigidBody]) -> None:
    """No support or prescribed motion may act on single nodes of a body."""
    for constraint in model.constraints:
        ruled = np.asarray(constraint.fixed.any(axis=1))
        ruled[getattr(constraint, "nodes", [])] = True  # also for a time only, or on one side
        for body in bodies:
            for row in body.nodes[ruled[body.nodes]]:
                what = (
                    f"its node {model.ids[row]} is ruled by {constraint.name}; "
                    "a rigid body is held by CMO of *MAT_RIGID, moved by *BOUNDARY_PRESCRIBED_MOTION_RIGID"
                )
                raise body.entry.error("pid", what)


def check_mass_loads(model: Model, bodies: list[RigidBody]) -> None:
    """A load or damping that acts on the mass of parts acts on all of a body, or on none of it."""
    loads = [(item.name, item.nodes) for item in model.forces if isinstance(item, BodyLoad | Centrifugal)]
    damping = [item for item in model.constraints if isinstance(item, MassDamping)]
    loads += [(item.name, nodes) for item in damping for nodes, *_ in item.terms]
    for name, nodes in loads:
        acted = np.zeros(model.ids.size, bool)
        acted[nodes] = True
        for body in bodies:
            if acted[body.nodes].any() and not acted[model.centre(body.number)]:
                what = f"{name} acts on parts that have nodes of this rigid body, but not on the body itself"
                raise body.entry.error("pid", what)


def check_mass_scaling(model: Model, bodies: list[RigidBody]) -> None:
    """No node of a body gains mass during the run: that mass would be at the node, not at the centre of the body."""
    scaled = np.zeros(model.ids.size, bool)
    for constraint in model.constraints:
        if isinstance(constraint, MassScaling):
            for block in constraint.blocks:
                scaled[block.nodes] = True
    for body in bodies:
        for row in body.nodes[scaled[body.nodes]]:
            what = (
                f"its node {model.ids[row]} is one of elements whose mass is scaled during the run, "
                "which is not supported; MS1ST = 1 is"
            )
            raise body.entry.error("pid", what)


def check_joints(deck: Deck, damping: Array | None, motions: list[PrescribedMotion]) -> None:
    """Joints work neither beside a prescribed motion of a centre nor with mass damping."""
    first = joint_entries(deck)[0]
    if any(motion.dof < 3 for motion in motions):
        raise first.error(None, "not supported beside a prescribed motion of the centre of a rigid body")
    if damping is not None:
        raise first.error(None, "not supported with mass damping")
