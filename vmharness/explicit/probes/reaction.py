"""Forces and moments of supports, prescribed motions, joints and rigid walls."""

from typing import Literal

import numpy as np

from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.constraints.spc import Supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes._quantity import Probe, ProbeError, choose, of_resultant, split
from vmharness.explicit.rigid.constraints import RigidBodies
from vmharness.explicit.walls.wall import PlanarWall


def of_support(model: Model, support: int | Literal["all"], component: str) -> Probe:
    """A component of the sum of all reactions of supports, or of those at one node: `z-force`, `x-moment`."""
    supports = [item for item in model.constraints if isinstance(item, Supports)]
    if not supports:
        raise ProbeError("no support in the deck")
    # One constraint holds all supports of a deck.
    if support == "all":
        return of_resultant(supports[0].total, component, "of a support")
    rows = np.flatnonzero(model.ids == support)
    if not rows.size or not supports[0].fixed[rows[0]].any():
        raise ProbeError(f"no support at node {support}")
    return of_resultant(supports[0].reaction[rows[0]], component, "of a support")


def of_motion(model: Model, motion: int, component: str) -> Probe:
    """A component of the force or moment of a prescribed motion on all its nodes: `z-force`, `x-moment`."""
    motions = [item for item in model.constraints if isinstance(item, PrescribedMotion)]
    if not 1 <= motion <= len(motions):
        raise ProbeError(f"no prescribed motion {motion}; the deck has {len(motions)}")
    return of_resultant(motions[motion - 1].total, component, "of a prescribed motion")


def of_joint(model: Model, joint: int, component: str) -> Probe:
    """A component of the force or moment of a joint on the body of its first node: `z-force`, `x-moment` about it."""
    for item in model.constraints:
        if isinstance(item, RigidBodies) and item.joints and 1 <= joint <= len(item.joints.total):
            return of_resultant(item.joints.total[joint - 1], component, "of a joint")
    raise ProbeError(f"no joint {joint} in the deck")


def of_wall(model: Model, wall: int, component: str) -> Probe:
    """A component of the force of a rigid wall on all nodes, or of its motion: `x-force`, `normal-velocity`.

    The axis is x, y, z or the normal of the wall. `impulse` is the sum of all impulses on the nodes so far.
    """
    walls = {item.number: item for item in model.constraints if isinstance(item, PlanarWall)}
    if wall not in walls:
        raise ProbeError(f"no rigid wall {wall}; there are: {', '.join(map(str, walls)) or 'none'}")
    found, s = walls[wall], model.state
    along, _, quantity = component.partition("-")
    axis = found.normal if along == "normal" else np.eye(3)[split(component)[0]]
    share = float(axis @ found.normal)
    probes: dict[str, Probe] = {
        "force": lambda: float(axis @ found.force),
        "impulse": lambda: float(axis @ found.impulse),
        "displacement": lambda: share * float(found.motion[0]),
        "velocity": lambda: share * found.velocity(s),
    }
    return choose(probes, quantity, "of a rigid wall")


PROBES = {"support": of_support, "motion": of_motion, "joint": of_joint, "wall": of_wall}
