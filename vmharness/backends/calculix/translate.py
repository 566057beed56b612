"""A deck as input of CalculiX, and what cannot be translated."""

from collections.abc import Iterable, Mapping
from functools import cache
from math import ceil

import numpy as np

from vmharness.backends._translation.review import built, declared, reviewed
from vmharness.backends.calculix import (
    beams,
    loads,
    masses,
    materials,
    motions,
    shells,
    solids,
    springs,
    velocities,
)
from vmharness.backends.calculix.channels import plan
from vmharness.backends.calculix.clock import Clock, amplitude
from vmharness.backends.calculix.model import Lines, Model, empty, real
from vmharness.backends.calculix.plan import Plan
from vmharness.case.format import Channel
from vmharness.deck import Deck, Entry, Finding
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.rule import only
from vmharness.deck.support import Supported, supports

MOST, FREE = 4000, 1000  # steps: at most; of bodies that nothing holds
WORK = 150_000  # steps times elements that are solids to CalculiX, at most: some minutes
COURANT = (
    0.5**0.5
)  # c dt/h of solids: errors (kh)^2/24 of their mass matrix and -(w dt)^2/12 of the step cancel

PASSES = (springs, beams, shells, solids, masses, motions, loads, velocities)


@cache
def supported() -> Supported:
    """What it represents of each keyword: SUPPORTS of the modules that translate."""
    return declared((*PASSES, materials), supports(CONTROL_TIMESTEP, dt2ms=only(0.0), lctm=only(0)))


def review(deck: Deck, channels: Mapping[str, Channel]) -> list[Finding]:
    """What of the deck is not represented, which channels are not reported, and what has no effect."""
    return reviewed(deck, channels, supported(), model_of, plan)


def model_of(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for what cannot be represented."""
    return built(deck, supported(), empty, PASSES)


def steps(model: Model) -> int:
    """How many steps: of TSSFAC times the critical step, for solids at most COURANT times it.

    Implicit steps are stable at any length: many elements have no more steps than one can wait for.
    """
    timestep = model.deck.first(CONTROL_TIMESTEP) or Entry.of_defaults(CONTROL_TIMESTEP)
    share = min(timestep.tssfac, COURANT) if model.work else timestep.tssfac
    explicit, end = share * critical_step(model), model.deck.one(CONTROL_TERMINATION).endtim
    if not np.isfinite(explicit):
        return FREE
    return min(ceil(end / explicit), MOST, int(WORK / max(model.work, 1.0)))


def critical_step(model: Model) -> float:
    """2/omega_max with the bound of Gershgorin, omega^2 <= max_i sum_j |K_ij|/m_i: L/c of a uniform bar."""
    free = model.used & (model.mass > 0.0) & (model.stiff > 0.0)
    if not free.any():
        return np.inf
    return float(2.0 / np.sqrt((model.stiff[free] / model.mass[free]).max()))


def written(model: Model, wanted: Iterable[Plan], clock: Clock) -> Lines:
    """All lines of the input file."""
    x = model.nodes.x0
    return [
        "*NODE,NSET=ALL",
        *(f"{row + 1},{','.join(map(real, x[row].tolist()))}" for row in np.flatnonzero(model.used).tolist()),
        *(f"{number},{','.join(map(real, place.tolist()))}" for number, place in _added(model)),
        *model.elements,
        *masses.anchors(model),
        *(line for lines in model.materials.values() for line in lines),
        *model.sections,
        *(line for name, path in model.motions.items() for line in amplitude(name, *path, clock)),
        *loads.amplitudes(model, clock),
        *model.equations,
        *_held(model),
        *velocities.lines(model),
        *_members(wanted),
        f"*STEP,NLGEOM,INC={2 * clock.count}",
        "*DYNAMIC,DIRECT,ALPHA=0",
        f"{real(clock.dt)},{real(clock.count * clock.dt)}",
        *model.driven,
        *loads.forces(model),
        *_printed(wanted),
        "*END STEP",
    ]


def _added(model: Model) -> Iterable[tuple[int, np.ndarray]]:
    return enumerate(model.added, 1 + model.nodes.ids.size)


def _held(model: Model) -> Lines:
    """*BOUNDARY of the supports; nodes of beams and shells alone can rotate."""
    held = model.held & model.used[:, None]
    held[:, 3:] &= model.rotating[:, None]
    values = [f"{row + 1},{dof + 1},{dof + 1}" for row, dof in np.argwhere(held).tolist()]
    return ["*BOUNDARY", *values] if values else []


def _members(wanted: Iterable[Plan]) -> Lines:
    """The sets of nodes and elements that are printed."""
    lines: Lines = []
    for kind, name, members in sorted({each for one in wanted for each in one.sets}):
        lines += [f"*{kind},{kind}={name}", *map(str, members)]
    return lines


def _printed(wanted: Iterable[Plan]) -> Lines:
    """What is printed at every step."""
    lines: Lines = []
    for head, quantity in sorted({each for one in wanted for each in one.printed}):
        lines += [head, quantity]
    return lines
