"""The protocol of a solver: what its module defines, and what the harness gives to it and takes from it.

    NAME                        its name in reports, before the version
    found()                     its version and place, or why it cannot run here; takes a moment, computes nothing
    review(deck, channels)      what it cannot represent and what has no effect, without a run
    supported()                 what it supports of each keyword; may be missing: then nobody can tell beforehand
    get_ready()                 imports that take long, so that they are no part of a run; may be missing
    reports(deck)               the energies that it can record of a deck, as channels by name
    solve(job)                  runs the deck; writes files in job.folder only

`channels` are those of a case: node, element, contact, energy, ... and the component of each. A solver starts a program
by `vmharness.execution.program.run`: the program then ends at the latest with the run, also if that is interrupted.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

from vmharness.case.format import Channel
from vmharness.deck import Deck, Finding
from vmharness.history import History


@dataclass(frozen=True)
class Found:
    """A solver on this machine."""

    version: str = ""  # as the solver gives it
    where: str = ""  # its program, or the folder of its package
    missing: str = ""  # why it cannot run here, and how to install it; empty if it can
    machine: str = ""  # compiler and processor, where the last digits depend on them
    notice: str = ""  # what a user should know before a first run


@dataclass(frozen=True)
class Job:
    """What a solver is to run."""

    deck: Deck  # resolved: parameters are numbers, includes stand in their place
    channels: Mapping[str, Channel]  # to record
    folder: Path  # for its files; fresh, and empty
    progress: Callable[[float], None] | None = None  # to be told how far it is, from 0 to 1


@dataclass(frozen=True)
class Output:
    """The outcome of a job."""

    history: History | None  # every channel that it gives, at the instants at which the solver writes
    failure: str = ""  # why the run ended before its end, or did not begin
    facts: Mapping[str, str] = field(default_factory=dict)  # time step, precision, interval, ...
    cycles: int = 0
    seconds: float = 0.0  # that the time loop took, where that is known
    notes: tuple[str, ...] = ()  # what of the deck cannot change results
    unrepresentable: str = ""  # why the solver cannot pose the problem of the deck, which is no failure of it
    unreported: Mapping[str, str] = field(default_factory=dict)  # channels that it does not give, and why


class Backend(Protocol):
    """A module that is a solver."""

    NAME: str

    def found(self) -> Found:
        """Version and place on this machine, or why it cannot run here."""

    def review(self, deck: Deck, channels: Mapping[str, Channel]) -> list[Finding]:
        """What it cannot represent of the deck, and which channels it cannot give; and what has no effect in it."""

    def reports(self, deck: Deck) -> dict[str, Channel]:
        """The energies of the whole model that it can record, by name; raises DeckError as `solve` does."""

    def solve(self, job: Job) -> Output:
        """Run the job; raises DeckError for what it cannot represent.

        Raises ProgramError where its program fails for reasons that are not the deck's, such as a missing licence.
        """


def full_name(backend: Backend, found: Found) -> str:
    """Name and version, as reports write them."""
    return f"{backend.NAME} {found.version}".strip()
