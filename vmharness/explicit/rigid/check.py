"""What rigid bodies of a deck cannot do together with supports, motions, loads and damping."""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.damping.mass import MassDamping
from vmharness.explicit.loads.body import BodyLoad, Centrifugal
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.rigid.joints import definitions
from vmharness.explicit.rigid.members import Member
from vmharness.explicit.timestep.mass_scaling import MassScaling


def check_free(model: Model, found: list[Member]) -> None:
    """No support or prescribed motion may rule a single node of a body."""
    for constraint in model.constraints:
        ruled = np.asarray(constraint.fixed.any(axis=1))
        ruled[getattr(constraint, "nodes", [])] = True  # those too that it rules for a time, or on one side
        for member in found:
            for row in member.nodes[ruled[member.nodes]]:
                what = (
                    f"its node {model.ids[row]} is ruled by {constraint.name}; "
                    "a rigid body is held by CMO of *MAT_RIGID, moved by *BOUNDARY_PRESCRIBED_MOTION_RIGID"
                )
                raise member.entry.error("pid", what)


def check_whole(model: Model, found: list[Member]) -> None:
    """What acts on the mass of a part acts on the whole of a body, or not at all."""
    loads = [(item.name, item.nodes) for item in model.forces if isinstance(item, BodyLoad | Centrifugal)]
    damping = [item for item in model.constraints if isinstance(item, MassDamping)]
    loads += [(item.name, nodes) for item in damping for nodes, *_ in item.terms]
    for name, nodes in loads:
        acted = np.zeros(model.ids.size, bool)
        acted[nodes] = True
        for member in found:
            if acted[member.nodes].any() and not acted[model.centre(member.number)]:
                what = f"{name} acts on parts that have nodes of this rigid body, but not on the body itself"
                raise member.entry.error("pid", what)


def check_scaling(model: Model, found: list[Member]) -> None:
    """Mass that comes during the run would stay on the node, where a body has its mass at the centre."""
    scaled = np.zeros(model.ids.size, bool)
    for constraint in model.constraints:
        if isinstance(constraint, MassScaling):
            for block in constraint.blocks:
                scaled[block.nodes] = True
    for member in found:
        for row in member.nodes[scaled[member.nodes]]:
            what = (
                f"its node {model.ids[row]} is one of elements whose mass is scaled during the run, "
                "which is not supported; MS1ST = 1 is"
            )
            raise member.entry.error("pid", what)


def check_joints(deck: Deck, bodies: Bodies, motions: list[PrescribedMotion]) -> None:
    """What joints are not made for."""
    first = definitions(deck)[0]
    if any(motion.dof < 3 for motion in motions):
        raise first.error(None, "not supported beside a prescribed motion of the centre of a rigid body")
    if bodies.damping is not None:
        raise first.error(None, "not supported with mass damping")
