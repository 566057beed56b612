"""The inertia of a rigid body is that about the origin, not about its centre."""

KIND = "physics"
MODULE = "vmharness.explicit.rigid.inertia"
SOUND = "r = x - centre\n"
FAULTY = "r = x\n"
KEYWORDS = (
    "MAT_RIGID",
    "MAT_020",
    "CONSTRAINED_NODAL_RIGID_BODY",
)
