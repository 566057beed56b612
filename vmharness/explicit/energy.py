"""Energies of a model, their ratio, and the check of their balance: an instability makes energy out of nothing."""

from collections.abc import Iterable

from vmharness.explicit.constraint import Constraint
from vmharness.explicit.force import Force
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.state import Array, State

# Energies that are stored or dissipated. With the kinetic energy they are the total energy.
STORED = (
    "internal", "spring and damper", "hourglass", "contact", "friction", "released", "damping", "rigid wall",
)  # fmt: skip
LIMIT = 10.0  # times the energy supplied: a run with more has diverged


def kinetic(state: State) -> float:
    """Kinetic energy at t_n, 1/2 sum m v_n^2 + I omega_n^2, with v_n = v_{n-1/2} + dt_{n-1}/2 a_n."""
    s = state
    return _kinetic(s.v, s.a, s.mass, s.omega, s.alpha, s.inertia, 0.5 * s.dt)


def kinetic_before(state: State) -> float:
    """Kinetic energy at t_{n-1/2}, without what the forces at t_n have added since."""
    s = state
    return _kinetic(s.v, s.a, s.mass, s.omega, s.alpha, s.inertia, 0.0)


class KineticEnergy:
    """The kinetic energy of a state, computed at most once a cycle."""

    def __init__(self, state: State) -> None:
        self.state, self.cycle, self.value = state, -1, 0.0
        self.others: list[Array] = []  # accounts (1,) of the rotation of rigid bodies, which add theirs

    def __call__(self) -> float:
        """1/2 sum m v_n^2 + I omega_n^2; valid while the time loop yields its state."""
        if self.cycle != self.state.cycle:
            others = sum([account.item() for account in self.others])
            self.cycle, self.value = self.state.cycle, kinetic(self.state) + others
        return self.value


@kernel
def _kinetic(
    v: Array, a: Array, mass: Array, omega: Array, alpha: Array, inertia: Array, half: float
) -> float:
    twice = 0.0
    for i in range(v.shape[0]):
        # Sums of one node: with one sum over all nodes each term would wait for the term before.
        v2 = omega2 = 0.0
        for j in range(3):
            v2 += (v[i, j] + half * a[i, j]) ** 2
            omega2 += (omega[i, j] + half * alpha[i, j]) ** 2
        twice += mass[i] * v2 + inertia[i] * omega2
    return 0.5 * twice


def accounts(items: Iterable[Force | Constraint], name: str) -> list[Array]:
    """The accounts (1,) of the energy `name` in all forces and constraints that keep one."""
    return [item.energy[name] for item in items if name in item.energy]


def stored(items: Iterable[Force | Constraint]) -> list[Array]:
    """The accounts (1,) of all energies that are stored or dissipated."""
    items = list(items)
    return [account for kind in STORED for account in accounts(items, kind)]


def ratio(total: float, initial: float, external_work: float) -> float:
    """Energy ratio: total energy / (initial energy + external work); 1 by definition while the divisor is zero.

    LS-DYNA prints the same ratio in glstat.
    """
    supplied = initial + external_work
    return total / supplied if supplied != 0.0 else 1.0


class Balance:
    """Total energy, compared with the largest energy that initial state and external work have supplied so far."""

    def __init__(self, state: State, kinetic: KineticEnergy, items: Iterable[Force | Constraint]) -> None:
        items = list(items)
        self.state, self.kinetic = state, kinetic
        self.stored, self.work = stored(items), accounts(items, "external work")
        self.initial = self.supplied = 0.0

    def excess(self) -> str:
        """What is wrong with the balance at t_n, if the total exceeds LIMIT times the energy supplied; else empty."""
        # A negative account must not hide what is wrong with others: it counts as zero.
        total = self.kinetic() + sum(max(account.item(), 0.0) for account in self.stored)
        if self.state.cycle == 0:
            self.initial = total
        supplied = abs(self.initial + sum(account.item() for account in self.work))
        self.supplied = max(self.supplied, supplied)
        # A load that begins at t_n has moved the nodes by half a step, but has no work before the next cycle.
        least = total - max(0.0, kinetic(self.state) - kinetic_before(self.state))
        if total > LIMIT * self.supplied and not least <= LIMIT * self.supplied:
            return f"the run has diverged: its energy is {total:.3g}, of which {self.supplied:.3g} was put in"
        return ""
