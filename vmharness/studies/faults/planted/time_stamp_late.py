"""Every time is stamped one step late."""

KIND = "reading"
MODULE = "vmharness.backends.builtin"
SOUND = "times.append(state.t)"
FAULTY = "times.append(state.t + state.dt)"
