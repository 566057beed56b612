"""What ends a run before its time."""

from vmharness.explicit.model.state import State


class SolverError(Exception):
    """The run cannot go on: at which time and cycle, why, and where."""

    def __init__(self, state: State, what: str, where: str = "") -> None:
        self.t, self.cycle = state.t, state.cycle
        place = f", {where}" if where else ""
        super().__init__(f"t = {state.t:.7g}, cycle {state.cycle}: {what}{place}")
