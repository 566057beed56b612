"""The time step is two and a half times as long as is stable."""

KIND = "integration"
MODULE = "vmharness.explicit.model"
SOUND = "self.step_factor * block"
FAULTY = "2.5 * self.step_factor * block"
