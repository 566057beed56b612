"""Mass damping has half of its coefficient."""

KIND = "physics"
MODULE = "vmharness.explicit.damping.mass"
SOUND = "damped = (a[i, j] - rate[i, j] * v[i, j]) / (1.0 + 0.5 * dt * rate[i, j])"
FAULTY = "damped = (a[i, j] - 0.5 * rate[i, j] * v[i, j]) / (1.0 + 0.25 * dt * rate[i, j])"
KEYWORDS = (
    "DAMPING_GLOBAL",
    "DAMPING_PART_MASS",
)
