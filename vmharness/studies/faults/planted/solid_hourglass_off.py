"""Solids do not resist their hourglass modes."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.solid.one_point.hourglass"
SOUND = "now = add(scale(memory, past), scale(gain * fixed[MODULUS * LANES + e], q))"
FAULTY = "now = (0.0, 0.0, 0.0)"
KEYWORDS = ("ELEMENT_SOLID",)
