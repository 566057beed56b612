"""The shear modulus of a solid is E / 2, not E / (2 (1 + nu))."""

KIND = "physics"
MODULE = "vmharness.explicit.materials.elastic"
SOUND = "    g = e / (2 * (1 + nu))\n    pressure"
FAULTY = "    g = e / 2\n    pressure"
KEYWORDS = ("ELEMENT_SOLID",)
