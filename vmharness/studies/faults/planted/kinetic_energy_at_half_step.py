"""The kinetic energy shown is that of half a step before."""

KIND = "reading"
MODULE = "vmharness.explicit.energy"
SOUND = "s.inertia, 0.5 * s.dt"
FAULTY = "s.inertia, 0.0"
