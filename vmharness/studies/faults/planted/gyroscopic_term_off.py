"""The angular velocity of a body does not follow the turning of its axes within a step."""

KIND = "physics"
MODULE = "vmharness.explicit.rigid.step"
SOUND = "e = frame(q[b], scale(0.5 * dt, before))"
FAULTY = "e = frame(q[b], scale(0.0 * dt, before))"
KEYWORDS = (
    "MAT_RIGID",
    "MAT_020",
    "CONSTRAINED_NODAL_RIGID_BODY",
)
