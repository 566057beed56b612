"""A rigid wall gives nodes back the velocity that they bring."""

KIND = "physics"
MODULE = "vmharness.explicit.walls.planar.law"
SOUND = "blow = mass[i] * max(0.0, motion[1] - trial[k])"
FAULTY = "blow = 2.0 * mass[i] * max(0.0, motion[1] - trial[k])"
KEYWORDS = ("RIGIDWALL_",)
