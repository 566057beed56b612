"""Forces at the nodes of a rigid body turn it the wrong way."""

KIND = "physics"
MODULE = "vmharness.explicit.rigid.step"
SOUND = "cross(subtract(row(x, i), place), push)"
FAULTY = "cross(subtract(place, row(x, i)), push)"
KEYWORDS = (
    "MAT_RIGID",
    "MAT_020",
    "CONSTRAINED_NODAL_RIGID_BODY",
)
