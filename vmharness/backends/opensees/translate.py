"""A deck as commands of OpenSees, and what cannot be translated."""

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from vmharness.backends._translation.review import built, declared, planned, reviewed
from vmharness.backends.opensees import beams, loads, masses, motions, shells, solids, springs, velocities
from vmharness.backends.opensees.channels import terms
from vmharness.backends.opensees.model import Command, Model, empty
from vmharness.case.format import Channel
from vmharness.deck import Deck, Entry, Finding
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.rule import only
from vmharness.deck.support import Supported, supports
from vmharness.mesh.supports import supported as supports_of

IMPLICIT, FREE = 4000, 1000  # steps: at most if they are implicit; of bodies that nothing holds

PASSES = (
    springs,
    beams,
    shells,
    solids,
    masses,
    motions,
    loads,
    velocities,
)  # loads act on the nodes that those before them use


@cache
def supported() -> Supported:
    """What it represents of each keyword: SUPPORTS of the modules that translate."""
    return declared(PASSES, supports(CONTROL_TIMESTEP, dt2ms=only(0.0), lctm=only(0)))


def review(deck: Deck, channels: Mapping[str, Channel]) -> list[Finding]:
    """What of the deck is not represented, which channels are not reported, and what has no effect."""
    return reviewed(deck, channels, supported(), model_of, terms)


def model_of(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for what cannot be represented."""
    return built(deck, supported(), empty, PASSES)


def task(model: Model, channels: Mapping[str, Channel]) -> tuple[dict[str, Any], dict[str, str]]:
    """All that the child process needs: commands, end, share of the critical step, channels; and what is not reported.

    The latter is by name of the channel, with the reason.
    """
    timestep = model.deck.first(CONTROL_TIMESTEP) or Entry.of_defaults(CONTROL_TIMESTEP)
    found, missing = planned(model, channels, terms)
    what = {
        "commands": commands(model),
        "end": model.deck.one(CONTROL_TERMINATION).endtim,
        "implicit": model.implicit,
        "step": step(model, timestep.tssfac),
        "channels": found,
    }
    return what, missing


def step(model: Model, share: float) -> float:
    """The step: TSSFAC times the critical one; with implicit steps, which are stable, at most IMPLICIT steps in all."""
    explicit, end = share * critical_step(model), model.deck.one(CONTROL_TERMINATION).endtim
    if not np.isfinite(explicit):
        return end / FREE
    return max(explicit, end / IMPLICIT) if model.implicit else explicit


def critical_step(model: Model) -> float:
    """2/omega_max with the bound of Gershgorin, omega^2 <= max_i sum_j |K_ij|/m_i: L/c of a uniform bar.

    A node with a held neighbour has a smaller sum; for springs to the ground this is not taken into account.
    """
    free = model.used & (model.mass > 0.0) & (model.stiff > 0.0)
    if not free.any():
        return np.inf
    return float(2.0 / np.sqrt((model.stiff[free] / model.mass[free]).max()))


def commands(model: Model) -> list[Command]:
    """All commands in the order in which OpenSees needs them."""
    rows, held = np.flatnonzero(model.used).tolist(), supports_of(model.deck, model.nodes)
    rotations = bool(model.inertia.any())
    size = 6 if rotations else 3
    if rotations:
        held[:, 3:] |= (model.inertia == 0.0)[:, None]
    x = model.nodes.x0
    return [
        ["model", "basic", "-ndm", 3, "-ndf", size],
        *(["node", model.id(row), *x[row].tolist()] for row in rows),
        *(["fix", model.id(row), *held[row, :size].astype(int).tolist()] for row in rows if held[row].any()),
        *(["mass", model.id(row), *_mass(model, row, rotations)] for row in rows),
        *_companion(model, size),
        *model.materials,
        *model.elements,
        *(_padded(command, size) for command in model.loads),
        *(
            _velocity(model, row, axis)
            for row in rows
            for axis in np.flatnonzero(model.velocities[row]).tolist()
        ),
    ]


def _companion(model: Model, size: int) -> list[Command]:
    """A free node with a mass, which nothing touches: OpenSees does not run where every node is driven."""
    tag = int(model.nodes.ids.max()) + 1
    return [["node", tag, 0.0, 0.0, 0.0], ["mass", tag, *size * [1.0]]]


def _mass(model: Model, row: int, rotations: bool) -> list[float]:
    """Lumped mass three times, and rotary inertia three times if nodes can rotate."""
    return 3 * [float(model.lumped[row])] + (3 * [float(model.inertia[row])] if rotations else [])


def _padded(command: Command, size: int) -> Command:
    """A nodal load with moments of zero, if nodes can rotate."""
    return [*command, 0.0, 0.0, 0.0] if size == 6 and command[0] == "load" else command


def _velocity(model: Model, row: int, axis: int) -> Command:
    return ["setNodeVel", model.id(row), int(axis) + 1, float(model.velocities[row, axis]), "-commit"]
