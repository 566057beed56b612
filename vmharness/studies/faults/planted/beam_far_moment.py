"""The far end of a beam takes as much moment as the near one."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.beam.belytschko_schwer.stiffness"
SOUND = "(2 - phi) * e * moment"
FAULTY = "(4 + phi) * e * moment"
KEYWORDS = ("ELEMENT_BEAM",)
