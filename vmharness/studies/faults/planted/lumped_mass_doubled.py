"""Every lumped mass counts twice."""

KIND = "physics"
MODULE = "vmharness.explicit.model"
SOUND = "np.add.at(self.state.mass, rows, mass)"
FAULTY = "np.add.at(self.state.mass, rows, 2.0 * mass)"
