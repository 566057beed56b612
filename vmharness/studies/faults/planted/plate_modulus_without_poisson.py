"""The modulus of a plate is E, not E / (1 - nu^2)."""

KIND = "physics"
MODULE = "vmharness.explicit.materials.elastic"
SOUND = "plate = e / (1 - nu * nu)"
FAULTY = "plate = e"
KEYWORDS = ("ELEMENT_SHELL",)
