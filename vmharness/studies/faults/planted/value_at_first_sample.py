"""A value is read at the first sample not before its time, not between samples."""

KIND = "reading"
MODULE = "vmharness.history"
SOUND = "return np.asarray(CubicHermiteSpline(time, values, slopes)(t))"
FAULTY = "return np.asarray(values[np.searchsorted(time, t)])"
