"""Probes: what can be read off a running model, every cycle, as functions of no argument."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit import energy
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.constraints.spc import Supports
from vmharness.explicit.force import Elements, Force, Scalable
from vmharness.explicit.model import Model
from vmharness.explicit.penalty.contact import Contact
from vmharness.explicit.state import Array
from vmharness.explicit.walls.planar.wall import PlanarWall

Probe = Callable[[], float]

AXES = {"x": 0, "y": 1, "z": 2}


class ProbeError(ValueError):
    """A quantity was asked for that the model does not have."""


def node(model: Model, nid: int, component: str) -> Probe:
    """A component of the motion of a node at t_n: `z-displacement`, `x-velocity`, `y-acceleration`, `z-coordinate`."""
    rows = np.flatnonzero(model.ids == nid)
    if not rows.size:
        raise ProbeError(f"no node {nid} in the deck")
    row, (axis, quantity) = int(rows[0]), _split(component)
    s, place = model.state, (row, axis)
    x0 = float(model.x0[place])
    probes: dict[str, Probe] = {
        "displacement": lambda: s.x[place] - x0,
        "coordinate": lambda: s.x[place],
        "velocity": lambda: s.v[place] + 0.5 * s.dt * s.a[place],  # v_{n-1/2} -> v_n
        "acceleration": lambda: s.a[place],
    }
    return _choose(probes, quantity, "of a node")


def contact(model: Model, number: int, component: str, nid: int | None = None) -> Probe:
    """A component of a contact: `z-force`, the resultant on surface A; `energy`, `friction energy`, `area`, `nodes`.

    Energy is that of the penalty and its damping, area and number are of the nodes in contact. With `nid`, the force on
    that tracked node, segments that it is a corner of not counted.
    """
    contacts = {force.number: force for force in model.forces if isinstance(force, Contact)}
    if number not in contacts:
        raise ProbeError(f"no contact {number}; there are: {', '.join(map(str, contacts)) or 'none'}")
    found = contacts[number]
    if nid is not None:
        places = np.flatnonzero(model.ids[found.tracked] == nid)
        if not places.size:
            raise ProbeError(f"no node {nid} among the tracked nodes of contact {number}")
        on_node = {f"{axis}-force": _summed(found, places, i) for axis, i in AXES.items()}
        return _choose(on_node, component, "on a node in contact")
    probes: dict[str, Probe] = {
        **{f"{axis}-force": found.force[i : i + 1].item for axis, i in AXES.items()},
        "energy": found.energy["contact"].item,
        "friction energy": found.energy["friction"].item,
        "area": found.area,
        "nodes": found.touching,
    }
    return _choose(probes, component, "of a contact")


def _summed(found: Contact, places: NDArray[np.intp], axis: int) -> Probe:
    """The sum of the forces on a node that is tracked once, or against both sides."""
    return lambda: float(found.forces[places, axis].sum())


def support(model: Model, component: str, nid: int | None = None) -> Probe:
    """A component of the sum of all reactions of supports, or of those at one node: `z-force`, `x-moment`."""
    supports = [item for item in model.constraints if isinstance(item, Supports)]
    if not supports:
        raise ProbeError("no support in the deck")
    # One constraint holds all supports of a deck.
    if nid is None:
        return _resultant(supports[0].total, component, "of a support")
    rows = np.flatnonzero(model.ids == nid)
    if not rows.size or not supports[0].fixed[rows[0]].any():
        raise ProbeError(f"no support at node {nid}")
    return _resultant(supports[0].reaction[rows[0]], component, "of a support")


def motion(model: Model, number: int, component: str) -> Probe:
    """A component of what a prescribed motion exerts on all its nodes: `z-force`, `x-moment`."""
    motions = [item for item in model.constraints if isinstance(item, PrescribedMotion)]
    if not 1 <= number <= len(motions):
        raise ProbeError(f"no prescribed motion {number}; the deck has {len(motions)}")
    return _resultant(motions[number - 1].total, component, "of a prescribed motion")


def wall(model: Model, number: int, component: str) -> Probe:
    """A component of what a rigid wall exerts on all nodes, or of its motion: `x-force`, `normal-velocity`.

    Along x, y, z or the wall's normal. `impulse` is all that the nodes have received.
    """
    walls = {item.number: item for item in model.constraints if isinstance(item, PlanarWall)}
    if number not in walls:
        raise ProbeError(f"no rigid wall {number}; there are: {', '.join(map(str, walls)) or 'none'}")
    found, s = walls[number], model.state
    along, _, quantity = component.partition("-")
    axis = found.normal if along == "normal" else np.eye(3)[_split(component)[0]]
    share = float(axis @ found.normal)
    probes: dict[str, Probe] = {
        "force": lambda: float(axis @ found.force),
        "impulse": lambda: float(axis @ found.impulse),
        "displacement": lambda: share * float(found.motion[0]),
        "velocity": lambda: share * found.velocity(s),
    }
    return _choose(probes, quantity, "of a rigid wall")


def centre(model: Model, part: int | None, component: str) -> Probe:
    """A component of the motion of the centre of mass, of the model or of a part: `x-velocity`, `x-momentum`.

    A part has the mass of its elements alone.
    """
    mass = model.state.mass if part is None else _mass_of(model, part)
    total = float(mass.sum())
    if total == 0.0:
        raise ProbeError(
            f"no elements with mass in part {part}" if part is not None else "no mass in the deck"
        )
    axis, quantity = _split(component)
    s, share, x0 = model.state, mass / total, model.x0[:, axis]

    def velocity() -> float:
        return float(share @ (s.v[:, axis] + 0.5 * s.dt * s.a[:, axis]))

    probes: dict[str, Probe] = {
        "displacement": lambda: float(share @ (s.x[:, axis] - x0)),
        "velocity": velocity,
        "momentum": lambda: total * velocity(),
    }
    return _choose(probes, quantity, "of a centre of mass")


def _mass_of(model: Model, part: int) -> Array:
    """What each node (n,) has of the mass of a part."""
    mass = np.zeros(model.ids.size)
    for force in model.forces:
        if isinstance(force, Scalable) and force.pid == part:
            np.add.at(mass, force.nodes, force.mass[:, None])
    return mass


def _resultant(total: Array, component: str, of: str) -> Probe:
    """Of force and moment (6,)."""
    axis, quantity = _split(component)
    return _choose({"force": lambda: total[axis], "moment": lambda: total[3 + axis]}, quantity, of)


def element(model: Model, kind: str, eid: int, component: str, point: int = 1) -> Probe:
    """A component of an element (kind shell, solid, beam or discrete) in its own frame: `xx-stress`, `axial-force`."""
    for force in model.forces:
        if isinstance(force, Elements) and force.kind == kind and eid in force.eid:
            try:
                return force.probe(int(np.flatnonzero(force.eid == eid)[0]), point, component)
            except ValueError as error:
                raise ProbeError(str(error)) from None
    raise ProbeError(f"no {kind} element {eid} in the deck")


def energies(model: Model, name: str, part: int | None = None) -> Probe:
    """An energy of the whole model: kinetic, total, ratio, or any that a force or constraint accounts for.

    With `part`, what the elements of that part account for: internal, hourglass, ...
    """
    items: list[Force | Constraint] = [*model.forces, *model.constraints]
    if part is not None:
        items = [item for item in items if isinstance(item, Elements) and item.pid == part]
    kinds = [*energy.STORED, "external work"]
    probes: dict[str, Probe] = {
        kind: _sum(accounts) for kind in kinds if (accounts := energy.accounts(items, kind)) or part is None
    }
    if part is None:
        probes |= _whole(
            model,
            probes["external work"],
            energy.stored(items),
        )
    return _choose(probes, name, f"of part {part}" if part is not None else "among the energies")


def _whole(model: Model, work: Probe, stored: list[Array]) -> dict[str, Probe]:
    """Kinetic and total energy, and the energy ratio."""
    s, kinetic, others, initial = model.state, model.kinetic, _sum(stored), 0.0

    def total() -> float:
        return kinetic() + others()

    def ratio() -> float:
        nonlocal initial
        if s.cycle == 0:
            initial = total()
        return energy.ratio(total(), initial, work())

    return {"kinetic": kinetic, "total": total, "ratio": ratio}


def _sum(accounts: list[Array]) -> Probe:
    """The sum of accounts (1,); most energies have one, which is then read without a detour."""
    return accounts[0].item if len(accounts) == 1 else lambda: sum([account.item() for account in accounts])


def _split(component: str) -> tuple[int, str]:
    axis, _, quantity = component.partition("-")
    if axis not in AXES or not quantity:
        raise ProbeError(f"component {component!r} is not of the form z-displacement")
    return AXES[axis], quantity


def _choose(probes: dict[str, Probe], name: str, of: str) -> Probe:
    try:
        return probes[name]
    except KeyError:
        raise ProbeError(f"no {name!r} {of}; there are: {', '.join(probes)}") from None
