"""Dampers feel half of the rate at which they are stretched."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.discrete.step"
SOUND = "law(constants, dt, d, rate, history, i"
FAULTY = "law(constants, dt, d, 0.5 * rate, history, i"
KEYWORDS = ("ELEMENT_DISCRETE",)
