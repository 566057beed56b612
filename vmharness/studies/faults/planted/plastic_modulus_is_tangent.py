"""The plastic modulus is Et, not E Et / (E - Et)."""

KIND = "physics"
MODULE = "vmharness.explicit.materials.plastic_kinematic"
SOUND = "E * entry.etan / (E - entry.etan)"
FAULTY = "entry.etan"
KEYWORDS = (
    "MAT_PLASTIC_KINEMATIC",
    "MAT_003",
)
