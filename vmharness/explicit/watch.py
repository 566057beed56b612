"""What is watched of a run beside its motion: the balance of its energies, and the step that its contacts need.

`impossible` is asked at the end of a run, wherever that is: a run with an energy that cannot be is no result.
"""

from vmharness.explicit.balance import LOOKS, MADE, Balance
from vmharness.explicit.model.model import Model
from vmharness.explicit.timestep.contact_steps import ContactSteps

EVERY = 50  # cycles between two looks at the energies
SERIES = 100  # cycles between two series of looks in successive cycles
CURES = {
    "hourglass": "likely cause: elements with one point of integration that bend, or are loaded at single nodes; a "
    "finer mesh, full integration (ELFORM), or stiffer *HOURGLASS would do",
    "damping": "likely cause: damping that is too strong for the step; a smaller TSSFAC would do",
    "balance": "likely cause: a step that is too long; a smaller TSSFAC would do",
}


class Watch:
    """Energies and contacts of a run, watched over time."""

    def __init__(self, model: Model, hourglass: bool = True) -> None:
        """`hourglass`: whether its energy is bounded, as it is unless the run is about it."""
        self.model = model
        self.balance, self.contacts = Balance(model, hourglass), ContactSteps(model)

    def look(self, ended: bool) -> str:
        """Look at the energies at t_n, if it is time; return what is wrong if the run has diverged."""
        cycle = self.model.state.cycle
        due = ended or cycle % EVERY == 0
        if not due and cycle % SERIES >= LOOKS:
            return ""
        excess = self.balance.excess()
        return excess if due else ""

    def blame(self) -> str:
        """The contact that is to blame for a run that has diverged, and what would mend it; empty if none."""
        return self.contacts.advice() if self.contacts.too_stiff else ""

    def impossible(self) -> str:
        """Which energy of the run cannot be, its bound, the likely cause, and what would mend it; empty if all can."""
        found = self.balance.impossible() or self._lost()
        if found is None:
            return ""
        kind, what = found
        stiff = self.contacts.advice() if kind in ("contact", "friction") or self.contacts.too_stiff else ""
        cause = stiff or CURES.get(kind, "")
        return f"{what}; {cause}" if cause else what

    def _lost(self) -> tuple[str, str] | None:
        name, energy = self.contacts.lost()
        if energy <= MADE * self.balance.supplied:
            return None
        what = f"the contact energy of {name}, which has no damper and has ended, is {energy:.3g}"
        return "contact", self.balance.said(what, MADE)
