"""The last support is lost."""

KIND = "physics"
MODULE = "vmharness.explicit.constraints.spc"
SOUND = "self.nodes, self.dofs = np.nonzero(fixed)"
FAULTY = "self.nodes, self.dofs = (places[:-1] for places in np.nonzero(fixed))"
