"""The penalty stiffness of a segment is K A, not K A / d."""

KIND = "physics"
MODULE = "vmharness.explicit.surface"
SOUND = "bulk * area / diagonal"
FAULTY = "bulk * area"
KEYWORDS = ("CONTACT_",)
