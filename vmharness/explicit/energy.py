"""Energies of a model, and their ratio."""

from collections.abc import Iterable

from vmharness.explicit.constraint import Constraint
from vmharness.explicit.force import Force
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.state import Array, State

# Energies that are stored or dissipated. With the kinetic energy they are the total energy.
STORED = (
    "internal", "spring and damper", "hourglass", "contact", "friction", "released", "damping", "rigid wall",
)  # fmt: skip


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
