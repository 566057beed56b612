"""Forces of prescribed motions."""

from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe, ProbeError, of_resultant

KEYS = ("motion",)


def probe(model: Model, motion: int, component: str) -> Probe:
    """A component of what a prescribed motion exerts on all its nodes: `z-force`, `x-moment`."""
    motions = [item for item in model.constraints if isinstance(item, PrescribedMotion)]
    if not 1 <= motion <= len(motions):
        raise ProbeError(f"no prescribed motion {motion}; the deck has {len(motions)}")
    return of_resultant(motions[motion - 1].total, component, "of a prescribed motion")
