"""Each corner of a face takes half of the pressure on it, not a quarter."""

KIND = "physics"
MODULE = "vmharness.explicit.loads.segment"
SOUND = "now = -factor[s] * p * shares[i][j]"
FAULTY = "now = -2.0 * factor[s] * p * shares[i][j]"
KEYWORDS = ("LOAD_SEGMENT",)
