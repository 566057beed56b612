"""*BOUNDARY_PRESCRIBED_MOTION_RIGID: the centre of a rigid body, or its rotation, that follows a curve.

The equations are those of nodes (prescribed_motion.py) at the centre of mass. DOF 5, 6, 7 give the component of the
angular velocity (VAD 0), of its rate (1), or of its integral (2) about a global axis. That integral is the angle of
rotation if the axis keeps its direction, as it does when the other rotations are held. A driven rotation lasts from the
beginning to the end of the run. Its moment is that about the centre.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.boundary.prescribed_motion_rigid import BOUNDARY_PRESCRIBED_MOTION_RIGID
from vmharness.deck.support import supports
from vmharness.explicit.constraints.prescribed_motion import MOTION, PrescribedMotion, build_motion
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import definitions, held_by_cmo, lead_number
from vmharness.mesh.dof import place

SUPPORTS = (supports(BOUNDARY_PRESCRIBED_MOTION_RIGID, **MOTION),)


def build(deck: Deck, model: Model) -> None:
    """Add a constraint on the centre of a body for each card; a degree of freedom may be ruled only once."""
    moved: set[tuple[int, int]] = set()
    first = 1 + sum(isinstance(c, PrescribedMotion) for c in model.constraints)
    for number, entry in enumerate(deck.all(BOUNDARY_PRESCRIBED_MOTION_RIGID), first):
        body, dof = lead_number(deck, entry, "pid"), place(entry)
        (definition,) = (other for other in definitions(deck) if other.pid == body)
        if held_by_cmo(deck, definition)[dof]:
            raise entry.error("dof", f"CMO of *MAT_RIGID holds body {body} in this direction")
        if (body, dof) in moved:
            raise entry.error("dof", f"another prescribed motion moves body {body} in this direction")
        moved.add((body, dof))
        motion = build_motion(deck, model, entry, np.array([model.centre(body)], np.intp), number)
        if dof >= 3 and not motion.throughout(model.end_time):
            raise entry.error("birth", "a driven rotation begins at 0 and lasts to the end of the run")
        model.constraints.append(motion)
