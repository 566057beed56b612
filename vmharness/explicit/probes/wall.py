"""Forces of a rigid wall, and its motion."""

import numpy as np

from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe, ProbeError, choose, split
from vmharness.explicit.walls.planar.wall import PlanarWall

KEYS = ("wall",)


def probe(model: Model, wall: int, component: str) -> Probe:
    """A component of what a rigid wall exerts on all nodes, or of its motion: `x-force`, `normal-velocity`.

    Along x, y, z or the wall's normal. `impulse` is all that the nodes have received.
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
