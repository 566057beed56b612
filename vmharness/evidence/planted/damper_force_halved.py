"""Dampers feel half of the rate at which they are stretched."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.discrete.step"
SOUND = "rate, history, i, nodes.shape[0]"
FAULTY = "0.5 * rate, history, i, nodes.shape[0]"
KEYWORDS = ("ELEMENT_DISCRETE",)
