"""Stiffness damping has half of its coefficient."""

KIND = "physics"
MODULE = "vmharness.explicit.damping.stiffness.law"
SOUND = "return beta / dt if dt > 0.0 else 0.0"
FAULTY = "return 0.5 * beta / dt if dt > 0.0 else 0.0"
KEYWORDS = ("DAMPING_PART_STIFFNESS",)
