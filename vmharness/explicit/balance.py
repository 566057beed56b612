"""The energy balance of a run, watched: an instability makes energy long before its numbers overflow."""

from vmharness.explicit import energy
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.error import SolverError
from vmharness.explicit.force import Force
from vmharness.explicit.model.model import Model

EVERY = 50  # cycles between two looks
LIMIT = 10.0  # times the energy that was ever put in


class Balance:
    """Total energy against the most that initial state and external work have put in so far."""

    def __init__(self, model: Model) -> None:
        self.model = model
        items: list[Force | Constraint] = [*model.forces, *model.constraints]
        self.stored = energy.stored(items)
        self.work = energy.accounts(items, "external work")
        self.initial = self.most = 0.0

    def watch(self, ended: bool) -> None:
        """Look every so many cycles, and when the run has ended; raises SolverError if energy came from nowhere."""
        state = self.model.state
        if state.cycle % EVERY and not ended:
            return
        # An account below zero has given what it never held: it is no excuse for what others have.
        total = self.model.kinetic() + sum(max(account.item(), 0.0) for account in self.stored)
        if state.cycle == 0:
            self.initial = total
        self.most = max(self.most, abs(self.initial + sum(account.item() for account in self.work)))
        if total > LIMIT * self.most:
            what = f"the run has diverged: its energy is {total:.3g}, of which {self.most:.3g} was put in"
            raise SolverError(state, what, self.model.wildest())
