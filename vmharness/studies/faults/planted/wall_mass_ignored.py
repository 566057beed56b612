"""A moving rigid wall keeps its velocity."""

KIND = "physics"
MODULE = "vmharness.explicit.walls.planar.law"
SOUND = "motion[1] = common(motion[1], inverse_mass, trial, mass, nodes)"
FAULTY = "motion[1] = common(motion[1], 0.0, trial, mass, nodes)"
KEYWORDS = (
    "RIGIDWALL_PLANAR_MOVING",
    "RIGIDWALL_PLANAR_FINITE_MOVING",
)
