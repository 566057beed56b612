"""`vm solve`: run a deck without a case."""

import os
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.options import FILE, solver_option
from vmharness.cli.say import STDOUT, complain, plain_table, say, say_table, write_file
from vmharness.suite.outcome import EXIT_CODES, Status

if TYPE_CHECKING:
    from vmharness.backends.protocol import Output
    from vmharness.case.format import Channel
    from vmharness.deck import Deck
    from vmharness.history import History

STATES = 1000  # in the file, where the deck does not ask for an interval


def _writable(context: click.Context, parameter: click.Parameter, path: Path | None) -> Path | None:
    """The file, if it can be written; raises BadParameter before anything is solved."""
    if path is not None and path != STDOUT:
        if not path.parent.is_dir():
            raise click.BadParameter(f"there is no folder {path.parent}")
        if not os.access(path if path.exists() else path.parent, os.W_OK):
            raise click.BadParameter(f"{path} cannot be written")
    return path


@click.command("solve")
@click.argument("path", metavar="DECK", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@solver_option()
@click.option(
    "--csv",
    type=FILE,
    metavar="FILE",
    callback=_writable,
    help="Write energies and nodal motion over time; - is standard output.",
)
def command(path: Path, solver: str, csv: Path | None) -> int:
    """Solve DECK and print its energies.

    The CSV file contains all energies, and the motion of the nodes of *DATABASE_HISTORY_NODE, _ID and _SET. Its
    interval is the smaller one of *DATABASE_NODOUT and *DATABASE_GLSTAT, but not below the time step; without them, the
    file contains 1000 instants.
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
        channels = chosen.reports(deck) | (_nodes(deck) if csv else {})
        with TemporaryDirectory(prefix="vmharness-") as folder:
            output = chosen.solve(Job(deck, channels, Path(folder)))
    except DeckError as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    except ProgramError as error:
        complain(str(error))
        return EXIT_CODES[Status.UNJUDGED]
    if output.history is not None and len(output.history):
        _say(deck, output, output.history)
        if csv:
            _write(deck, output.history, csv)
    if output.failure:
        complain(output.failure)
        return EXIT_CODES[Status.UNJUDGED]
    return 0


def _nodes(deck: "Deck") -> "dict[str, Channel]":
    """The motion of every node of *DATABASE_HISTORY_NODE, _ID and _SET."""
    from vmharness.case.format import Channel
    from vmharness.mesh.histories import history_nodes
    from vmharness.mesh.nodes import nodes_of

    return {
        f"node {nid} {axis}-{quantity}": Channel(text="", node=nid, component=f"{axis}-{quantity}")
        for nid in history_nodes(deck, nodes_of(deck))
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


def _write(deck: "Deck", history: "History", path: Path) -> None:
    """Write the samples at the output interval of the deck."""
    from vmharness.reading import states

    asked = [
        entry.dt for name in ("NODOUT", "GLSTAT") for entry in deck.all(f"DATABASE_{name}") if entry.dt > 0
    ]
    chosen = states(history, min(asked, default=float(history.time[-1]) / STATES))
    text = StringIO()
    history.samples(chosen).to_csv(text)
    write_file(path, text.getvalue())
    if path != STDOUT:
        say(f"written: {path}")
