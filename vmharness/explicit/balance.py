"""The energy balance of a run: energies that cannot be make its results worthless.

    E = K + sum of the energies that are stored or dissipated        S = E_0 + external work        E = S in theory

A run has no result where one of these is found; the bounds refer to the largest |S| of the run, the energy put in:

    during the run   E (without negative accounts) > 30 |S|     the run has diverged, and ends
    at its end       |E - S| > 5 %                              energy is made or lost by the integration
                     contact, friction, hourglass or damping energy < -5 %
                                                                these resist or store: a negative one is energy from
                                                                nothing, although the balance closes
                     contact energy > 5 % in a contact without damper that has ended: it is lost
                     hourglass energy > 10 %                    deformation that the elements do not resist by stress

5 % of energy is 2.5 % of velocity, more than any tolerance of a verification should allow. 10 % of hourglass energy is
what users of LS-DYNA accept; a case that records the hourglass energy of a part is about it, and not bounded.

In a vibration of central differences K and the stored energy at t_n are out of step. With exact initial velocity the
amplitude is 1/sqrt(1 - q) of the true one, q = (omega dt / 2)^2, and E lies between S and S / (1 - q); what stays the
same is

    E - dt^2/8 sum m a^2

The error of the balance lies between this and E, and counts where it has one sign in LOOKS looks, some of them in
successive cycles. A run has diverged when E exceeds what 0.98 of the stable
step could make of S.
"""

from collections import deque
from dataclasses import dataclass

from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import accounts, kinetic, kinetic_before, stored
from vmharness.explicit.force import Force
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array

DIVERGED = 30.0  # times the energy supplied
MADE = 0.05  # of the energy put in: more than this is not made or lost by round-off and the step
HOURGLASS = 0.1  # of the energy put in
LOOKS = 4
RESISTING = ("contact", "friction", "hourglass", "damping")  # energies that cannot be negative


@dataclass
class Resisting:
    """The account (1,) of an energy that cannot be negative, with its least value so far."""

    owner: str
    kind: str
    account: Array
    least: float = 0.0


class Balance:
    """The energies of a run, watched over time."""

    def __init__(self, model: Model, hourglass: bool = True) -> None:
        """`hourglass`: whether the hourglass energy is bounded."""
        items: list[Force | Constraint] = [*model.forces, *model.constraints]
        self.model, self.state = model, model.state
        self.stored, self.work = stored(items), accounts(items, "external work")
        self.hourglass = accounts(items, "hourglass") if hourglass else []
        self.resisting = [
            Resisting(item.name, kind, item.energy[kind])
            for item in items
            for kind in RESISTING
            if kind in item.energy
        ]
        self.initial = self.supplied = self.made = self.lost = self.most_hourglass = 0.0
        self.pressed = 0.0  # energy of contacts that begin under pressure, which is no work
        self.errors = deque[tuple[float, float]](maxlen=LOOKS)  # bounds of the error in the last looks

    def excess(self) -> str:
        """What is wrong with the balance at t_n, if the run has diverged; else empty."""
        now = [account.item() for account in self.stored]
        negative = sum(min(value, 0.0) for value in now)
        total = self.model.kinetic() + sum(now)
        if self.state.cycle == 0:
            self.initial, self.pressed = total, -negative
        supplied = self.initial + sum(account.item() for account in self.work)
        self.supplied = max(self.supplied, abs(supplied), abs(supplied + self.pressed))
        error = total - supplied
        self.errors.append((error - self._out_of_step(), error))
        if len(self.errors) == LOOKS:
            self.made = max(self.made, min(least for least, _ in self.errors))
            self.lost = max(self.lost, -max(most for _, most in self.errors))
        self.most_hourglass = max(self.most_hourglass, sum(account.item() for account in self.hourglass))
        for one in self.resisting:
            one.least = min(one.least, one.account.item())
        # A negative account must not hide what is wrong with others: it counts as zero.
        total -= negative
        # A load that begins at t_n has moved the nodes by half a step, but has no work before the next cycle.
        early = max(0.0, kinetic(self.state) - kinetic_before(self.state))
        if total > DIVERGED * self.supplied and not total - early <= DIVERGED * self.supplied:
            return f"the run has diverged: its energy is {total:.3g}, of which {self.supplied:.3g} was put in"
        return ""

    def _out_of_step(self) -> float:
        """dt^2/8 sum m a^2, with rotations."""
        s = self.state
        return float(0.125 * s.dt**2 * (s.mass @ (s.a**2).sum(axis=1) + s.inertia @ (s.alpha**2).sum(axis=1)))

    def impossible(self) -> tuple[str, str] | None:
        """Kind of an energy of the run that cannot be, or "balance", and what is wrong with it; None if all can be."""
        bound = MADE * self.supplied
        for one in self.resisting:
            if one.least < -bound:
                what = f"the {one.kind} energy of {one.owner} has fallen to {one.least:.3g}"
                return one.kind, self.said(what, -MADE)
        if max(self.made, self.lost) > bound:
            what = f"{self.made:.3g} was made" if self.made > self.lost else f"{self.lost:.3g} was lost"
            return "balance", self.said(f"the energy balance is open: {what}", MADE)
        if self.most_hourglass > HOURGLASS * self.supplied:
            what = f"the hourglass energy has come to {self.most_hourglass:.3g}"
            return "hourglass", self.said(what, HOURGLASS)
        return None

    def said(self, what: str, bound: float) -> str:
        """A sentence on an energy that cannot be, with its bound as a fraction of the energy put in."""
        return (
            f"the run cannot be judged: {what}, where {self.supplied:.3g} was put in, and the bound is "
            f"{100.0 * bound:g} % of it"
        )
