"""Nodes of a rigid body are turned by half of its rotation."""

KIND = "physics"
MODULE = "vmharness.explicit.rigid.step"
SOUND = "turn(q[b], scale(dt, w))"
FAULTY = "turn(q[b], scale(0.5 * dt, w))"
KEYWORDS = (
    "MAT_RIGID",
    "MAT_020",
    "CONSTRAINED_NODAL_RIGID_BODY",
)
