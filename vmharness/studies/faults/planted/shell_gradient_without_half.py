"""The gradient at the centre of a shell is divided by its area, not by twice that."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.shell.belytschko_tsay.frame"
SOUND = "B1 = (dot(r24, e2) / double_area, -dot(r13, e2) / double_area)"
FAULTY = "B1 = (2 * dot(r24, e2) / double_area, -2 * dot(r13, e2) / double_area)"
KEYWORDS = ("ELEMENT_SHELL",)
