"""The built-in explicit finite-element code.

The solver and its compiler are imported in the functions that need them: commands that only ask for the version start
without.
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
UNKEPT = (
    "compiled kernels cannot be kept, so that each run compiles them again ({}); "
    "set VMHARNESS_CACHE to a folder that can be written"
)


def found() -> Found:
    """Version, folder and machine; a notice while no kernel is compiled."""
    from vmharness.explicit.kernels.cache import folder, is_cold, unwritable

    return Found(
        version=vmharness.__version__,
        where=str(Path(vmharness.__file__).parent / "explicit"),
        machine=folder().name,
        notice=UNKEPT.format(why) if (why := unwritable()) else COLD if is_cold() else "",
    )


def review(deck: "Deck", channels: "Mapping[str, Channel]") -> "list[Finding]":
    """What is not supported in the deck, which channels its model does not have, and what has no effect."""
    from vmharness.backends.builtin.channels import findings

    return findings(deck, channels)


def supported() -> "Supported":
    """What it supports of each keyword."""
    from vmharness.explicit.supported import supported

    return supported()


def reports(deck: "Deck") -> "dict[str, Channel]":
    """The energies that the model of the deck has, as channels by name."""
    from vmharness.backends.builtin.channels import energies

    return energies(deck)


def get_ready() -> None:
    """Import the solver and its compiler, before the time of a run begins."""
    from vmharness.backends.builtin import cycles  # noqa: F401


def solve(job: Job) -> Output:
    """Run the deck and record the channels every cycle."""
    from vmharness.backends.builtin.cycles import run

    return run(job)
