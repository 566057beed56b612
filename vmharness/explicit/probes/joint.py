"""Forces of joints between rigid bodies."""

from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe, ProbeError, of_resultant
from vmharness.explicit.rigid.bodies import Bodies

KEYS = ("joint",)


def probe(model: Model, joint: int, component: str) -> Probe:
    """A component of what a joint exerts on the body of its first node: `z-force`, `x-moment` about that node."""
    for bodies in model.constraints:
        if isinstance(bodies, Bodies) and bodies.joints and 1 <= joint <= len(bodies.joints.total):
            return of_resultant(bodies.joints.total[joint - 1], component, "of a joint")
    raise ProbeError(f"no joint {joint} in the deck")
