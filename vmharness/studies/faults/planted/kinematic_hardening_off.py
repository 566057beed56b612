"""Hardening is isotropic, whatever BETA says."""

KIND = "physics"
MODULE = "vmharness.explicit.materials.plastic_kinematic"
SOUND = "(1.0 - entry.beta) * E_p,\n        line(entry.sigy, entry.beta * E_p)"
FAULTY = "0.0,\n        line(entry.sigy, E_p)"
KEYWORDS = ("MAT_PLASTIC_KINEMATIC", "MAT_003")
