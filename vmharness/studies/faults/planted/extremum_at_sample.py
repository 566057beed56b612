"""An extremum is taken at its outermost sample."""

KIND = "reading"
MODULE = "vmharness.events"
SOUND = "return [_vertex(time, values, i) for i in"
FAULTY = "return [float(time[i]) for i in"
