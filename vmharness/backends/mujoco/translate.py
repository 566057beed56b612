"""A deck as a model of MuJoCo, and what cannot be translated."""

from collections.abc import Mapping
from functools import cache
from typing import Any

from vmharness.backends._translation.review import built, declared, planned, reviewed
from vmharness.backends.mujoco import (
    contacts,
    damping,
    joints,
    loads,
    masses,
    rigid,
    shells,
    springs,
    trusses,
    velocities,
)
from vmharness.backends.mujoco.channels import terms
from vmharness.backends.mujoco.element import node_name
from vmharness.backends.mujoco.forces import GRIP, IMPEDANCE
from vmharness.backends.mujoco.model import Model, empty
from vmharness.case.format import Channel
from vmharness.deck import Deck, Finding
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.rule import only
from vmharness.deck.support import Supported, supports

# Bodies take masses and velocities of nodes; joints, loads and contacts act on bodies.
PASSES = (springs, trusses, shells, masses, velocities, rigid, damping, joints, loads, contacts)
SHOWN = 12  # facts of contacts


@cache
def supported() -> Supported:
    """What it represents of each keyword: SUPPORTS of the modules that translate."""
    return declared(PASSES, supports(CONTROL_TIMESTEP, dt2ms=only(0.0)))


def review(deck: Deck, channels: Mapping[str, Channel]) -> list[Finding]:
    """What of the deck is not represented, which channels are not reported, and what has no effect."""
    return reviewed(deck, channels, supported(), model_of, terms)


def model_of(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for what cannot be represented."""
    model = built(deck, supported(), empty, PASSES)
    masses.check(deck, model)
    return model


def task(model: Model, channels: Mapping[str, Channel]) -> tuple[dict[str, Any], dict[str, str]]:
    """What the child process needs beside the model; and the channels that are not reported, with why."""
    found, missing = planned(model, channels, terms)
    what = {
        "end": model.deck.one(CONTROL_TERMINATION).endtim,
        "loads": [
            [node_name(model.id(load.row)), load.vector.tolist(), load.t.tolist(), load.value.tolist()]
            for load in model.loads
        ],
        "bases": [[base.vector.tolist(), base.t.tolist(), base.value.tolist()] for base in model.bases],
        "channels": found,
        "facts": _facts(model),
    }
    return what, missing


def _facts(model: Model) -> dict[str, str]:
    """What of the model a reader must know to judge the results."""
    found = {}
    for contact in model.contacts[:SHOWN]:
        how = (
            "a spring with a dead band"
            if contact.spring
            else f"solref = -k/m with the impedance {IMPEDANCE:g}"
        )
        found[f"Contact {contact.number}"] = f"stiffness {contact.stiffness:.6g}, by {how}"
    if any(contact.friction for contact in model.contacts):
        found["Friction"] = f"elliptic cones, noslip, sticking at the rate {GRIP:g}/dt"
    return found
