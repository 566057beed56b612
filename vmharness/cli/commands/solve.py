"""`vm solve`: a deck that belongs to no case, through the built-in solver."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.say import complain, plain_table, say, say_table
from vmharness.suite.outcome import EXIT_CODES, Status

if TYPE_CHECKING:
    from vmharness.deck import Deck
    from vmharness.explicit.model.model import Model
    from vmharness.explicit.probes import Probe
    from vmharness.history import History

STATES = 1000  # in the file, where the deck does not ask for an interval


@click.command("solve")
@click.argument("path", metavar="DECK", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@click.option(
    "--csv", type=click.Path(path_type=Path, dir_okay=False), help="Write energies and nodes over time."
)
def command(path: Path, csv: Path | None) -> int:
    """Solve DECK and say what became of its energy.

    The file has all energies, and the motion of the nodes of *DATABASE_HISTORY_NODE, at the interval of
    *DATABASE_NODOUT or _GLSTAT, else at 1000 instants.
    """
    from vmharness.backends.builtin import record
    from vmharness.deck import DeckError, read, vocabulary
    from vmharness.explicit.build import build
    from vmharness.explicit.probes import ProbeError

    try:
        deck = read(path, vocabulary())
        model = build(deck)
        probes = _probes(deck, model)
    except (DeckError, ProbeError) as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    history, failure, seconds = record(model, probes)
    _say(deck, model, history, seconds)
    if csv:
        _states(deck, history).to_csv(csv)
        say(f"written: {csv}")
    if failure:
        complain(failure)
        return EXIT_CODES[Status.UNJUDGED]
    return 0


def _probes(deck: "Deck", model: "Model") -> "dict[str, Probe]":
    from vmharness.explicit import energy
    from vmharness.explicit.constraint import Constraint
    from vmharness.explicit.force import Force
    from vmharness.explicit.probes import probe

    items: list[Force | Constraint] = [*model.forces, *model.constraints]
    kept = [kind for kind in (*energy.STORED, "external work") if energy.accounts(items, kind)]
    probes = {name: probe(model, energy=name) for name in ("kinetic", *kept, "total", "ratio")}
    for entry in deck.all("DATABASE_HISTORY_NODE"):
        for nid in entry.ids.tolist():
            for quantity in ("displacement", "velocity"):
                for axis in "xyz":
                    name = f"{axis}-{quantity}"
                    probes[f"node {nid} {name}"] = probe(model, node=nid, component=name)
    return probes


def _say(deck: "Deck", model: "Model", history: "History", seconds: float) -> None:
    from vmharness.explicit.contact.limits import limits_reached

    say(f"{deck.path.name}: {deck.title}")
    facts = model.facts | limits_reached(model)
    for sentence in (*deck.notes, *(f"{name}: {fact}" for name, fact in facts.items())):
        say(f"  {sentence}")
    say(f"  {model.ids.size} nodes, {model.state.cycle} cycles to t = {model.state.t:.6g} in {seconds:.2f} s")
    table = plain_table("Energy", "at the beginning", "largest", "at the end")
    for name in history.channels:
        if not name.startswith("node "):
            values = history[name]
            table.add_row(name, *(f"{value:.6g}" for value in (values[0], abs(values).max(), values[-1])))
    say_table(table)


def _states(deck: "Deck", history: "History") -> "History":
    """The samples at the deck's output interval."""
    from vmharness.reading import states

    asked = [entry.dt for name in ("NODOUT", "GLSTAT") for entry in deck.all(f"DATABASE_{name}") if entry.dt]
    chosen = states(history, min(asked, default=float(history.time[-1]) / STATES))
    return history.samples(chosen)
