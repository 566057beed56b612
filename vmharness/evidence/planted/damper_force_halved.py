"""Dampers feel half of the rate at which they are stretched."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.discrete.step"
SOUND = "dt, elongation[i], rate, history, i"
FAULTY = "dt, elongation[i], 0.5 * rate, history, i"
KEYWORDS = ("ELEMENT_DISCRETE",)
