"""CalculiX, the free finite element code, driven by its input file.

What of a deck it can represent is translated entry by entry (job.inp in the work folder); the rest is refused by name.
It runs *DYNAMIC, DIRECT, ALPHA=0: Newmark's method with beta = 1/4 and gamma = 1/2, at constant steps, with large
displacements. Its results are read from job.dat, where they have seven digits.
"""

import re
import shutil
import subprocess
from collections.abc import Mapping
from typing import TYPE_CHECKING

from vmharness.backends.protocol import Found, Job, Output

if TYPE_CHECKING:
    from vmharness.case.format import Channel
    from vmharness.deck import Deck, Finding
    from vmharness.deck.support import Supported

NAME = "calculix"
PROGRAM = "ccx"
INSTALL = "CalculiX (the program ccx) is not installed: apt-get install calculix-ccx, or see calculix.de"


def found() -> Found:
    """The version of CalculiX, or how to install it."""
    program = shutil.which(PROGRAM)
    if program is None:
        return Found(missing=INSTALL)
    try:
        printed = subprocess.run(
            [program, "-v"], capture_output=True, text=True, timeout=60, check=False
        ).stdout
    except (OSError, subprocess.TimeoutExpired) as error:
        return Found(missing=f"{program} -v: {error}")
    version = re.search(r"Version (\S+)", printed)
    if version is None:
        return Found(missing=f"{program} -v prints no version of CalculiX")
    return Found(version=version[1], where=program)


def supported() -> "Supported":
    """What it represents of each keyword."""
    from vmharness.backends.calculix.translate import supported

    return supported()


def review(deck: "Deck", channels: "Mapping[str, Channel]") -> "list[Finding]":
    """What it cannot represent, and which channels it cannot give."""
    from vmharness.backends.calculix.translate import review

    return review(deck, channels)


def reports(deck: "Deck") -> "dict[str, Channel]":
    """The kinetic and the internal energy, where it records them."""
    from vmharness.backends.calculix.channels import energies
    from vmharness.backends.calculix.translate import model_of

    return energies(model_of(deck))


def solve(job: Job) -> Output:
    """Translate the deck, run ccx, read the history that it has printed."""
    from vmharness.backends.calculix.program import run

    return run(job)
