"""The first velocity is taken a whole step, not half a step, from the start."""

KIND = "integration"
MODULE = "vmharness.explicit.loop"
SOUND = "0.5 * (s.dt + dt)"
FAULTY = "dt"
