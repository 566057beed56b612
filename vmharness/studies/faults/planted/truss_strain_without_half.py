"""The strain increment of a truss is half of what it is."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.beam.truss"
SOUND = "law(constants, dt, 2 * elongation / double"
FAULTY = "law(constants, dt, elongation / double"
KEYWORDS = ("ELEMENT_BEAM",)
