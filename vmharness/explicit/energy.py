"""Energies and their balance."""

from collections.abc import Iterable

from vmharness.explicit.constraint import Constraint
from vmharness.explicit.force import Force
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.state import Array, State

# Stored or dissipated: with the kinetic energy, the total. See `ratio`.
STORED = (
    "internal", "spring and damper", "hourglass", "contact", "friction", "released", "damping", "rigid wall",
)  # fmt: skip


def kinetic(state: State) -> float:
    """Kinetic energy at t_n, 1/2 sum m v_n^2 + I omega_n^2, with v_n = v_{n-1/2} + dt_{n-1}/2 a_n."""
    s = state
    return _kinetic(s.v, s.a, s.mass, s.omega, s.alpha, s.inertia, 0.5 * s.dt)


class KineticEnergy:
    """The kinetic energy of a state, computed once a cycle however many ask."""

    def __init__(self, state: State) -> None:
        self.state, self.cycle, self.value = state, -1, 0.0
        self.others: list[Array] = []  # accounts (1,) of what is not in the state's inertia: rigid bodies

    def __call__(self) -> float:
        """1/2 sum m v_n^2 + I omega_n^2; to be asked for while the time loop shows its state."""
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
        moving = turning = 0.0  # summed by node: a sum over all waits for each of its terms
        for j in range(3):
            moving += (v[i, j] + half * a[i, j]) ** 2
            turning += (omega[i, j] + half * alpha[i, j]) ** 2
        twice += mass[i] * moving + inertia[i] * turning
    return 0.5 * twice


def accounts(items: Iterable[Force | Constraint], name: str) -> list[Array]:
    """The accounts (1,) of the energy `name` in all forces and constraints that keep one."""
    return [item.energy[name] for item in items if name in item.energy]


def stored(items: Iterable[Force | Constraint]) -> list[Array]:
    """The accounts (1,) of all energies that are stored or dissipated."""
    items = list(items)
    return [account for kind in STORED for account in accounts(items, kind)]


def ratio(total: float, initial: float, external_work: float) -> float:
    """Total energy / (initial energy + external work); 1 by definition while that is zero.

    Total = kinetic + all of STORED. (LS-DYNA's glstat prints the same ratio.)
    """
    put_in = initial + external_work
    return total / put_in if put_in != 0.0 else 1.0
