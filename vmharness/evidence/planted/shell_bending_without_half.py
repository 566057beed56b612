"""The height of a point in a shell is counted from full, not half, the thickness."""

KIND = "physics"
MODULE = "vmharness.explicit.shell.point"
SOUND = "z, dz = 0.5 * thickness * zeta, 0.5 * thickness * weight"
FAULTY = "z, dz = thickness * zeta, 0.5 * thickness * weight"
KEYWORDS = ("ELEMENT_SHELL",)
