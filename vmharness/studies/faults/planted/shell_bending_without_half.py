"""The height of a point in a shell is counted from full, not half, the thickness."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.shell._point"
SOUND = "z, dz = 0.5 * thickness * zeta, 0.5 * thickness * weight"
FAULTY = "z, dz = thickness * zeta, 0.5 * thickness * weight"
KEYWORDS = ("ELEMENT_SHELL",)
