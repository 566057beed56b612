"""The stress of a solid does not turn with the material."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.solid._motion"
SOUND = "t = half(scale(0.25 * dt, spin))"
FAULTY = "t = half(scale(0.0 * dt, spin))"
KEYWORDS = ("ELEMENT_SOLID",)
