"""The velocity shown is that of half a step before."""

KIND = "reading"
MODULE = "vmharness.explicit.probe"
SOUND = "s.v[place] + 0.5 * s.dt * s.a[place]"
FAULTY = "s.v[place]"
