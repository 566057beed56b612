"""`vm solve`: run a deck without a case."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.options import solver_option
from vmharness.cli.say import complain, plain_table, say, say_table
from vmharness.suite.outcome import EXIT_CODES, Status

if TYPE_CHECKING:
    from vmharness.backends.protocol import Output
    from vmharness.case.format import Channel
    from vmharness.deck import Deck
    from vmharness.history import History

STATES = 1000  # in the file, where the deck does not ask for an interval


@click.command("solve")
@click.argument("path", metavar="DECK", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@solver_option()
@click.option(
    "--csv",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Write energies and nodal motion over time.",
)
def command(path: Path, solver: str, csv: Path | None) -> int:
    """Solve DECK and print its energies.

    The CSV file contains all energies, and the motion of the nodes of *DATABASE_HISTORY_NODE. Its interval is the
    smaller one of *DATABASE_NODOUT and *DATABASE_GLSTAT; without them, it contains 1000 instants.
    """
    from tempfile import TemporaryDirectory

    from vmharness.backends import calls
    from vmharness.backends.protocol import Job
    from vmharness.deck import DeckError, read, vocabulary
    from vmharness.execution.program import ProgramError

    chosen = calls.solver(solver)
    if missing := chosen.found().missing:
        complain(f"{chosen.NAME} cannot run here: {missing}")
        return EXIT_CODES[Status.UNJUDGED]
    try:
        deck = read(path, vocabulary())
        channels = chosen.reports(deck) | _nodes(deck)
        with TemporaryDirectory(prefix="vmharness-") as folder:
            output = chosen.solve(Job(deck, channels, Path(folder)))
    except DeckError as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    except ProgramError as error:
        complain(str(error))
        return EXIT_CODES[Status.UNJUDGED]
    if output.history is not None:
        _say(deck, output, output.history)
        if csv:
            _states(deck, output.history).to_csv(csv)
            say(f"written: {csv}")
    if output.failure:
        complain(output.failure)
        return EXIT_CODES[Status.UNJUDGED]
    return 0


def _nodes(deck: "Deck") -> "dict[str, Channel]":
    """The motion of every node of *DATABASE_HISTORY_NODE."""
    from vmharness.case.format import Channel

    return {
        f"node {nid} {axis}-{quantity}": Channel(text="", node=nid, component=f"{axis}-{quantity}")
        for entry in deck.all("DATABASE_HISTORY_NODE")
        for nid in entry.ids.tolist()
        for quantity in ("displacement", "velocity")
        for axis in "xyz"
    }


def _say(deck: "Deck", output: "Output", history: "History") -> None:
    say(f"{deck.path.name}: {deck.title}")
    facts = [f"{name}: {fact}" for name, fact in output.facts.items()]
    for sentence in (*deck.notes, *output.notes, *facts):
        say(f"  {sentence}")
    say(f"  {output.cycles} cycles to t = {history.time[-1]:.6g} in {output.seconds:.2f} s")
    table = plain_table("Energy", "at the beginning", "largest", "at the end")
    for name in history.channels:
        if not name.startswith("node "):
            values = history[name]
            table.add_row(name, *(f"{value:.6g}" for value in (values[0], abs(values).max(), values[-1])))
    say_table(table)


def _states(deck: "Deck", history: "History") -> "History":
    """The samples at the output interval of the deck."""
    from vmharness.reading import states

    asked = [entry.dt for name in ("NODOUT", "GLSTAT") for entry in deck.all(f"DATABASE_{name}") if entry.dt]
    chosen = states(history, min(asked, default=float(history.time[-1]) / STATES))
    return history.samples(chosen)
