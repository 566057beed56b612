"""The gradient of a solid along xi lacks half of its constant part."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.solid._gradient"
SOUND = "b1 = add(scale(8.0, cross(x2, x3)), scale(8 / 3, cross(x6, x5)))"
FAULTY = "b1 = add(scale(4.0, cross(x2, x3)), scale(8 / 3, cross(x6, x5)))"
KEYWORDS = ("ELEMENT_SOLID",)
