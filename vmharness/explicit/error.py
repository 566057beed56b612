"""The error that ends a run."""

from vmharness.explicit.state import State


class SolverError(Exception):
    """A run that cannot continue; the message has time, cycle, reason and place."""

    def __init__(self, state: State, what: str, where: str = "") -> None:
        self.t, self.cycle = state.t, state.cycle
        place = f", {where}" if where else ""
        super().__init__(f"t = {state.t:.7g}, cycle {state.cycle}: {what}{place}")
