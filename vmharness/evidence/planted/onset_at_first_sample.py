"""An onset is taken at the first sample that shows it."""

KIND = "reading"
MODULE = "vmharness.events"
SOUND = "first = np.flatnonzero(on[1:] & ~on[:-1]) + 1\n"
FAULTY = "first = np.flatnonzero(on[1:] & ~on[:-1]) + 1\n    return [float(time[i]) for i in first]\n"
