"""The built-in explicit finite-element code.

The solver and its compiler are imported where they are used: to ask for the version takes a moment only.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import vmharness
from vmharness.backends.protocol import Found, Job, Output

if TYPE_CHECKING:
    from vmharness.case.format import Channel
    from vmharness.deck import Deck, Finding
    from vmharness.deck.support import Supported

NAME = "vmharness"
COLD = "compiling the kernels of the solver: the first run takes up to a minute longer"


def found() -> Found:
    """It is this package."""
    from vmharness.explicit.kernels.cache import folder, is_cold

    return Found(
        version=vmharness.__version__,
        where=str(Path(vmharness.__file__).parent / "explicit"),
        machine=folder().name,
        notice=COLD if is_cold() else "",
    )


def review(deck: "Deck", channels: "Mapping[str, Channel]") -> "list[Finding]":
    """What keeps it from running the deck, the channels that the model does not have, and what has no effect."""
    from vmharness.backends.builtin.channels import findings

    return findings(deck, channels)


def supported() -> "Supported":
    """What it supports of each keyword."""
    from vmharness.explicit.supported import supported

    return supported()


def reports(deck: "Deck") -> "dict[str, Channel]":
    """The energies of which the model of the deck keeps an account."""
    from vmharness.backends.builtin.channels import energies

    return energies(deck)


def solve(job: Job) -> Output:
    """Run the deck and record the channels every cycle."""
    from vmharness.backends.builtin.cycles import run

    return run(job)
