"""OpenSees, driven by its Python interface in a child process.

What of a deck it can represent is translated entry by entry into commands of OpenSees (model.json in the work folder);
the rest is refused by name. It runs Newmark's method with beta = 0 and gamma = 1/2, the central differences of
explicit codes, from the accelerations of the first loads, at the step that the deck asks for.
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

NAME = "opensees"
INSTALL = "OpenSeesPy is not installed: pip install 'vmharness[opensees]'"


def found() -> Found:
    """The version of OpenSeesPy, or how to install it."""
    spec = util.find_spec("openseespy")
    if spec is None:
        return Found(missing=INSTALL)
    return Found(version=metadata.version("openseespy"), where=str(spec.origin or sys.prefix))


def supported() -> "Supported":
    """What it represents of each keyword."""
    from vmharness.backends.opensees.translate import supported

    return supported()


def review(deck: "Deck", channels: "Mapping[str, Channel]") -> "list[Finding]":
    """What it cannot represent, and which channels it cannot give."""
    from vmharness.backends.opensees.translate import review

    return review(deck, channels)


def reports(deck: "Deck") -> "dict[str, Channel]":
    """The kinetic energy: other energies it does not record."""
    from vmharness.case.format import Channel

    return {"kinetic": Channel(text="kinetic", energy="kinetic")}


def solve(job: Job) -> Output:
    """Translate the deck, run it in a child process, read the history that it has written."""
    from vmharness.backends.opensees.program import run

    return run(job)
