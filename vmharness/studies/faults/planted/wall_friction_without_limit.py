"""Nothing slides on a rigid wall with friction."""

KIND = "physics"
MODULE = "vmharness.explicit.walls.planar.build"
SOUND = "return math.inf if entry.fric == 1.0 else float(entry.fric)"
FAULTY = "return math.inf if entry.fric else 0.0"
KEYWORDS = ("RIGIDWALL_",)
