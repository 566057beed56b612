"""Energies of the model, or of a part."""

from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import STORED, accounts, stored
from vmharness.explicit.energy import ratio as ratio_of
from vmharness.explicit.force import Elements, Force
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes._quantity import Probe, choose
from vmharness.explicit.state import Array


def of_energy(model: Model, energy: str, part: int | None = None) -> Probe:
    """An energy of the whole model: kinetic, total, ratio, or any for which forces or constraints have an account.

    With `part`, the energies of its elements alone: internal, hourglass, ...
    """
    items: list[Force | Constraint] = [*model.forces, *model.constraints]
    if part is not None:
        items = [item for item in items if isinstance(item, Elements) and item.pid == part]
    kinds = [*STORED, "external work"]
    probes: dict[str, Probe] = {
        kind: _sum(found) for kind in kinds if (found := accounts(items, kind)) or part is None
    }
    if part is None:
        probes |= _whole(model, probes["external work"], stored(items))
    return choose(probes, energy, f"of part {part}" if part is not None else "among the energies")


def _whole(model: Model, work: Probe, others: list[Array]) -> dict[str, Probe]:
    """Kinetic and total energy, and the energy ratio."""
    s, kinetic, rest, initial = model.state, model.kinetic, _sum(others), 0.0

    def total() -> float:
        return kinetic() + rest()

    def ratio() -> float:
        nonlocal initial
        if s.cycle == 0:
            initial = total()
        return ratio_of(total(), initial, work())

    return {"kinetic": kinetic, "total": total, "ratio": ratio}


def _sum(accounts: list[Array]) -> Probe:
    """The sum of accounts (1,); a single account is read directly, which is faster."""
    return accounts[0].item if len(accounts) == 1 else lambda: sum([account.item() for account in accounts])


PROBES = {"energy": of_energy}
