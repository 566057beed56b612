"""An onset is taken at the first sample that shows it."""

KIND = "reading"
MODULE = "vmharness.events"
SOUND = "return [_root_beside(time, values, int(i), 1) for i in first]"
FAULTY = "return [float(time[i]) for i in first]"
