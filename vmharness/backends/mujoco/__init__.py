"""MuJoCo, driven by its Python package in a child process.

What of a deck it can represent is translated into a model of MuJoCo (model.xml in the work folder, which its viewer
opens): masses on slide joints, springs and dampers as tendons, rigid bodies, contacts of masses with flat fixed
surfaces. The rest is refused by name. It runs the Runge-Kutta method of the fourth order, at the step that the deck
asks for.
"""

import sys
from collections.abc import Mapping
from importlib import metadata, util
from typing import TYPE_CHECKING

from vmharness.backends.protocol import Found, Job, Output

if TYPE_CHECKING:
    from vmharness.case.format import Channel
    from vmharness.deck import Deck, Finding
    from vmharness.deck.support import Supported

NAME = "mujoco"
INSTALL = "MuJoCo is not installed: pip install 'vmharness[mujoco]'"


def found() -> Found:
    """The version of MuJoCo, or how to install it."""
    spec = util.find_spec("mujoco")
    if spec is None:
        return Found(missing=INSTALL)
    return Found(version=metadata.version("mujoco"), where=str(spec.origin or sys.prefix))


def supported() -> "Supported":
    """What it represents of each keyword."""
    from vmharness.backends.mujoco.translate import supported

    return supported()


def review(deck: "Deck", channels: "Mapping[str, Channel]") -> "list[Finding]":
    """What it cannot represent, and which channels it cannot give."""
    from vmharness.backends.mujoco.translate import review

    return review(deck, channels)


def reports(deck: "Deck") -> "dict[str, Channel]":
    """The kinetic energy, and that of springs where no contact is one; other energies it does not record."""
    from vmharness.backends.mujoco.translate import model_of
    from vmharness.case.format import Channel

    names = ("kinetic",) if model_of(deck).contacts else ("kinetic", "internal")
    return {name: Channel(text=name, energy=name) for name in names}


def solve(job: Job) -> Output:
    """Translate the deck, run it in a child process, read the history that it has written."""
    from vmharness.backends.mujoco.program import run

    return run(job)
