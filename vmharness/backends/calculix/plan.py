"""How a channel is had: what CalculiX is to print, and how its values follow from that."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from vmharness.backends._translation.review import NotReportedError
from vmharness.backends.calculix.dat import Array, Key
from vmharness.backends.calculix.model import Member, Model
from vmharness.case.format import Channel

Printed = Mapping[Key, Array]
AXES = {"x": 0, "y": 1, "z": 2}
HEADS = {"displacements": "U", "velocities": "V", "forces": "RF"}


@dataclass(frozen=True)
class Plan:
    """Sets (kind, name, members) and printed quantities (card, label) of a channel; its values (steps,) from them.

    `start` is its value at t = 0, at which CalculiX prints nothing; None where it is not known.
    """

    value: Callable[[Printed], Array]
    sets: frozenset[tuple[str, str, tuple[int, ...]]]
    printed: frozenset[tuple[str, str]]
    start: float | None = None


def of_nodes(value: Callable[[Printed], Array], name: str, rows: list[int], *quantities: str) -> Plan:
    sets = {("NSET", name, tuple(row + 1 for row in rows))}
    printed = {(f"*NODE PRINT,NSET={name}", HEADS[quantity]) for quantity in quantities}
    return Plan(value, frozenset(sets), frozenset(printed))


def of_elements(value: Callable[[Printed], Array], name: str, numbers: list[int], label: str) -> Plan:
    how = {"S": ",GLOBAL=YES", "ELSE": ",TOTALS=ONLY", "ELKE": ",TOTALS=ONLY"}.get(
        label, ""
    )  # not local axes
    sets = {("ELSET", name, tuple(numbers))}
    return Plan(value, frozenset(sets), frozenset({(f"*EL PRINT,ELSET={name}{how}", label)}))


def joined(value: Callable[[Printed], Array], *plans: Plan, start: float | None = None) -> Plan:
    sets, printed = (
        frozenset().union(*(getattr(one, what) for one in plans)) for what in ("sets", "printed")
    )
    return Plan(value, sets, printed, start)


def split(channel: Channel, known: tuple[str, ...]) -> tuple[int, str]:
    """Axis and quantity of a component such as x-velocity."""
    axis, _, quantity = str(channel.component).partition("-")
    if axis not in AXES or quantity not in known:
        raise NotReportedError(f"calculix does not report {channel.component!r} of {channel.text!r}")
    return AXES[axis], quantity


def ends_of(model: Model, member: Member) -> Callable[[Printed], Array]:
    """The vector (steps, 3) from the first node of an element to the second."""
    first, second = member.rows
    x0 = model.nodes.x0[second] - model.nodes.x0[first]

    def vector(printed: Printed) -> Array:
        u = [printed["displacements", f"NODE{row + 1}"][:, 0, 1:] for row in (first, second)]
        return np.asarray(x0 + u[1] - u[0])

    return vector
