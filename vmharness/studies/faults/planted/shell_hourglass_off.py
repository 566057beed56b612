"""Shells do not resist their hourglass modes."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.shell.belytschko_tsay.hourglass"
SOUND = "Q = np.array([[control.qm], [control.qw], [control.qb]])"
FAULTY = "Q = np.zeros((3, 1))"
KEYWORDS = ("ELEMENT_SHELL",)
