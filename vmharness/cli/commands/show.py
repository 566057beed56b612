"""`vm show`: a case on one screen."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.cli.options import READING, solver_option, timeout_option
from vmharness.cli.say import complain, plain_table, say, say_table
from vmharness.cli.selection import CASES, read_apart, selected
from vmharness.suite.outcome import EXIT_CODES, NOTHING_SELECTED, Status

if TYPE_CHECKING:
    from vmharness.case import Case


@click.command("show")
@click.argument("selector", metavar="ID")
@CASES
@solver_option()
@timeout_option(READING)
def command(selector: str, cases: Path | None, solver: str, timeout: float) -> int:
    """Show a case: data, theory, deck, tolerances, faults.

    Each formula of the theory is shown with its value.

    ID is an id, or the path of a case folder.
    """
    found, _ = selected((selector,), cases, "", ())
    if not found:
        complain("nothing selected")
        return NOTHING_SELECTED
    sound, broken = read_apart(found, timeout, reviewed=False)
    for outcome in broken:
        complain(outcome.reason)
    for case in sound:
        for part in (_head, _given, _theory, _results, _faults):
            part(case)
        _deck(case, solver)
    return EXIT_CODES[Status.BROKEN] if broken else 0


def _head(case: "Case") -> None:
    say(f"\n{case.id}: {case.file.title}\n{case.file.reference}")


def _given(case: "Case") -> None:
    table = plain_table("Given", "Value", "Unit", "")
    for name, given in case.file.given.items():
        table.add_row(name, f"{given.value:.7g}", given.unit, given.text)
    say_table(table)


def _theory(case: "Case") -> None:
    from vmharness.case.format import Line
    from vmharness.formula import Unit

    table = plain_table("Theory", "Value", "Unit", "Formula", "")
    for name, line in case.file.theory.items():
        line = line if isinstance(line, Line) else Line(formula=line)
        unit = line.unit or case.units.name(case.dimensions[name])
        value = case.theory[name] / case.units.factor(Unit(unit))
        table.add_row(name, f"{value:.7g}", unit, line.formula, line.text)
    say_table(table)


def _results(case: "Case") -> None:
    from vmharness.case.tolerance import allowed, budget
    from vmharness.formula import Unit
    from vmharness.report.number import fraction

    table = plain_table("Result", "Target", "Unit", "Tolerance (%)", "Budget (%)", "Event", "Channel")
    for result in case.file.results:
        target = case.target(result.key) / case.units.factor(Unit(result.unit))
        expected = budget(case, result.key)
        table.add_row(
            result.key,
            f"{target:.7g}",
            result.unit,
            fraction(allowed(case, result.key), target, result.unit),
            fraction(expected, target, result.unit),
            case.file.events[result.event].title,
            result.channel,
        )
    say_table(table)


def _faults(case: "Case") -> None:
    table = plain_table("Declared fault", "Change", "Must fail")
    for fault in case.file.faults:
        change = ", ".join(f"{name} {by}" for name, by in fault.change.items())
        table.add_row(fault.text, change, ", ".join(fault.must_fail))
    say_table(table)


def _deck(case: "Case", solver: str) -> None:
    from collections import Counter

    import numpy as np

    from vmharness.backends import calls
    from vmharness.case import CaseError
    from vmharness.case.deck import read_deck
    from vmharness.deck import DeckError
    from vmharness.deck.support import effects

    try:
        deck = read_deck(case)
    except (CaseError, DeckError) as error:
        say(f"deck: {error}")
        return
    rows: Counter[str] = Counter()
    for entry in deck.entries:
        if entry.keyword.unique in ("nid", "eid"):
            rows[entry.keyword.name] += np.size(entry.values[entry.keyword.unique])
    keywords = Counter(entry.keyword.name for entry in deck.entries)
    say(f"{case.deck_name}: {deck.title}")
    say("parameters: " + ", ".join(f"{name} = {value}" for name, value in deck.parameters.items()))
    say("model: " + ", ".join(f"{count} *{name}" for name, count in rows.items()))
    say("keywords: " + ", ".join(f"*{name}" + (f" ({n})" if n > 1 else "") for name, n in keywords.items()))
    for note in (*deck.notes, *effects(deck, calls.supported(solver) or {})):
        say(f"note: {note}")
