"""The step that the contacts of a run need, found while they act: for stability, and for the energy of an impact.

Stability: active contacts add their stiffness to that of the elements at their nodes. Where the sum of the limits,

    (dt / dt_elements)^2 + (dt / dt_contacts)^2 > 1

leaves it open whether the step is stable, the highest mode of elements and active contacts together decides. It is
found when more contacts are active than before, and every EVERY cycles. The step is not shortened during the run; a
fact says what it should not exceed, and names a node. limits.py has shortened it for what can be known before.

Impact: a contact begins and ends within a step, but its force acts as if it did so at the end of one. A node that comes
with the velocity v gains or loses up to k (v dt)^2 / 8 at the beginning, and as much at the end, which is

    (dt omega / 2)^2 = (dt / dt_contacts)^2      omega^2 = k / m

of its energy at most, by the phase at which it meets the step. To keep the energy to MADE (balance.py) the step is
sqrt(MADE) of the stable one.
"""

import math

import numpy as np

from vmharness.explicit.balance import MADE
from vmharness.explicit.contact.active_step import Active, Linearised, active_step
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.model.model import Model
from vmharness.explicit.timestep.highest_mode import highest_mode

EVERY = 1000  # cycles between two looks at contacts that do not become more
MORE = 1.1  # times the contacts of the last look: so many are looked at again
MOST_MODES = 20  # of a run
REPEATS = 6  # until the longest stable step is found


class ContactSteps:
    """The contacts of a model, watched over time."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.contacts = [force for force in model.forces if isinstance(force, Contact)]
        self.passes = [one for contact in self.contacts for one in contact.passes]
        held = np.zeros(model.ids.size, bool)
        for constraint in model.constraints:
            held |= constraint.fixed[:, :3].all(axis=1)
        mass = model.state.lumped
        self.inverse = np.divide(1.0, mass, out=np.zeros_like(mass), where=(mass > 0.0) & ~held)
        self.stiffest: tuple[float, float, Contact] | None = (
            None  # its stable step, the step then, the contact
        )
        self._shortest = math.inf  # that was said
        self._looked, self._next, self._modes = 0, 0, 0

    def look(self, dt: float, elements: float) -> None:
        """Look at the contacts that are active in the step `dt`; `elements` alone are stable up to their step."""
        active = sum([one.parameters["active"].item() for one in self.passes])
        cycle = self.model.state.cycle
        if active <= MORE * self._looked and (cycle < self._next or active == 0):
            return
        self._looked, self._next = max(active, self._looked), cycle + EVERY
        contact = min(self.contacts, key=lambda one: self._limit([one]).dt)
        alone, together = self._limit([contact]), self._limit(self.contacts)
        if self.stiffest is None or alone.dt / dt < self.stiffest[0] / self.stiffest[1]:
            self.stiffest = alone.dt, dt, contact
        if (dt / elements) ** 2 + (dt / together.dt) ** 2 > 1.0 and self._modes < MOST_MODES:
            self._modes += 1
            longest = self._stable(dt)
            if longest < dt and longest < self._shortest:
                self._shortest = longest
                self._say(contact, longest, dt, together.row)

    @property
    def too_stiff(self) -> bool:
        """Whether contacts have been too stiff for the step."""
        return math.isfinite(self._shortest)

    def advice(self) -> str:
        """The step, or the stiffness, with which impacts would keep their energy; empty without contacts."""
        if self.stiffest is None:
            return ""
        stable, dt, contact = self.stiffest
        enough = MADE**0.5 * stable
        if dt <= enough:
            return "likely cause: contacts that begin or end under pressure"
        options, factor = contact.options, (enough / dt) ** 2
        softer = f"SOFSCL = {_below(options.sofscl * factor)}"
        if options.soft == 0:
            softer = f"{self._shorter(enough)}SLSFAC = {_below(options.slsfac * factor)}"
        return (
            f"likely cause: {contact.name} is stiff for the step {dt:.3g}; an impact keeps its energy to "
            f"{100.0 * MADE:g} % with a step of at most {enough:.3g}, as by {softer}"
        )

    def lost(self) -> tuple[str, float]:
        """The contact without damper that has ended with the most energy in its springs, and that energy."""
        ended = [
            (contact.energy["contact"].item(), contact.name)
            for contact in self.contacts
            if contact.options.vdc == 0.0 and contact.nodes_in_contact() == 0
        ]
        energy, name = max(ended, default=(0.0, ""))
        return name, energy

    def _limit(self, contacts: list[Contact]) -> Active:
        return active_step(contacts, self.model.state.lumped, self.inverse)

    def _stable(self, dt: float) -> float:
        """The longest step up to `dt` that is stable for elements and active contacts together."""
        others = [Linearised(one, self.model.state.lumped) for one in self.passes]
        for _ in range(REPEATS):
            theta = highest_mode(self.model, dt, others=others).theta
            if not theta > 1.0:
                break
            dt /= theta**0.5 if theta > 1.01 else 1.01
        return dt

    def _say(self, contact: Contact, longest: float, dt: float, row: int) -> None:
        enough = MADE**0.5 * longest
        self.model.facts[f"Step of {contact.name}"] = (
            f"should not exceed {enough:.4g}, but was {dt:.4g}: the contacts that were active at "
            f"t = {self.model.state.t:.4g} are stable up to {longest:.4g}, and keep the energy of impacts to "
            f"{100.0 * MADE:g} % up to the former; node {self.model.ids[row]} limits it"
            + (f"; {self._shorter(enough)[:-4]} would do" if self.model.blocks else "")
        )

    def _shorter(self, step: float) -> str:
        """TSSFAC of a step, where elements set it."""
        own = min((block.stable_step() for block in self.model.blocks), default=math.inf)
        return f"TSSFAC = {_below(step / own)} or " if math.isfinite(own) else ""


def _below(value: float) -> str:
    """The value with two digits, rounded down.

    >>> _below(0.1298), _below(1.0)
    ('0.12', '1')
    """
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return f"{math.floor(value / unit * (1.0 + 1e-12)) * unit:.2g}"
