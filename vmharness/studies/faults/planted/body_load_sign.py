"""A body load acts along its acceleration, not against it."""

KIND = "physics"
MODULE = "vmharness.explicit.loads.body"
SOUND = "self.acceleration, -self.sf * self.curve(state.t)"
FAULTY = "self.acceleration, self.sf * self.curve(state.t)"
KEYWORDS = ("LOAD_BODY_",)
