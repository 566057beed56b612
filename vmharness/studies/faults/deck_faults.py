"""Faults of a deck as variants of its case: the theory, and so the targets, stay as they are.

One number is wrong, by a few percent, in its sign or in its unit; or supports are missing.
"""

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from vmharness.case import Case, CaseError
from vmharness.case.deck import read_deck
from vmharness.deck import Deck, DeckError, Entry
from vmharness.studies.changed_deck import with_entries
from vmharness.studies.faults.declared import RUN_LENGTH
from vmharness.studies.variant import Variant

PERCENTS = (0.1, -0.1, 1.0, -1.0, 5.0, -5.0)
OTHER_SIGN = "of the other sign"  # which most decks must not have
SLIP = 1000.0  # between a unit and its thousandth
LARGEST = 20  # a wrong unit makes the mesh no more than so many times as large: it would only be waited for
MODEL = "Model"  # the group of the data that are no part of the problem


@dataclass(frozen=True)
class Planted:
    """A fault in a case, before it is run."""

    name: str
    text: str
    kind: str
    variant: Variant


def parameter_faults(case: Case, cycles: int) -> list[Planted]:
    """Each number that the problem sets in the deck, wrong alone; a wrong unit ends after so many `cycles`.

    Of the numbers that a template makes its mesh of, those of the model are left alone: they number nodes.
    """
    deck = case.file.deck
    most = LARGEST * len(case.deck_source()) or math.inf
    found: list[Planted] = []
    for name, formula in deck.parameters.items():
        if formula != RUN_LENGTH:
            found += _wrong(name, case.evaluate(f"parameter {name}"), _parameter(case, name), cycles, most)
    for name, value in case.mesh_parameters().items():
        if not is_of_model(case, f"mesh {name}"):
            found += _wrong(name, value, _mesh(case, name), cycles, most)
    return found


def support_faults(case: Case) -> list[Planted]:
    """Without the last support of the deck, and without any."""
    if not _supports(read_deck(case)):
        return []
    none = with_entries(case, lambda deck: _without(deck, _supports(deck)))
    last = with_entries(case, lambda deck: _without(deck, _supports(deck)[-1:]))
    return [_fault("the last support is missing", last), _fault("all supports are missing", none)]


def is_of_model(case: Case, formula: str) -> bool:
    """Whether a formula has data of the model alone, none of the problem."""
    return all(case.file.given[datum].group == MODEL for datum in case.origins(formula))


def _fault(name: str, case: Case) -> Planted:
    return Planted(name, f"In the deck, {name}", "deck", Variant(case, name))


def _wrong(
    name: str, value: float, make: Callable[[float], Case], cycles: int, most: float
) -> Iterator[Planted]:
    """What can be wrong with a number that is not 0, where the deck then has no more than `most` characters."""
    if value == 0.0:
        return
    changes = [(f"{percent:+g} %", 1.0 + percent / 100.0) for percent in PERCENTS]
    for text, factor in [*changes, (OTHER_SIGN, -1.0), (f"{SLIP:g} times as large", SLIP)]:
        with suppress(CaseError):
            case = make(factor * value)
            case.deck_source(most)  # raises where a template makes none
            yield _fault(f"{name} {text}", _ended(case, cycles) if factor == SLIP else case)


def _parameter(case: Case, name: str) -> Callable[[float], Case]:
    return lambda value: replace(case, planted={**case.deck_parameters(), name: value})


def _mesh(case: Case, name: str) -> Callable[[float], Case]:
    return lambda value: replace(case, planted_mesh={**case.planted_mesh, name: value})


def _ended(case: Case, cycles: int) -> Case:
    """The run ends after so many cycles; a deck that cannot be read is left for the solver to refuse."""

    def change(entry: Entry) -> Entry:
        if entry.keyword.name != "CONTROL_TERMINATION":
            return entry
        return replace(entry, values={**entry.values, "endcyc": entry.endcyc or cycles})

    try:
        return with_entries(case, lambda deck: map(change, deck.entries))
    except DeckError:
        return case


def _supports(deck: Deck) -> list[tuple[Entry, int]]:
    """Each support as its entry and its row there: nodes with a code, then cards of *BOUNDARY_SPC, whose row is -1."""
    nodes = [(entry, int(row)) for entry in deck.all("NODE") for row in np.flatnonzero(entry.tc | entry.rc)]
    return nodes + [(entry, -1) for entry in deck.entries if entry.keyword.name.startswith("BOUNDARY_SPC")]


def _without(deck: Deck, gone: list[tuple[Entry, int]]) -> list[Entry]:
    """The entries of the deck without these supports."""
    found = []
    for entry in deck.entries:
        rows = [row for owner, row in gone if owner is entry]
        if -1 in rows:
            continue
        if rows:
            codes = {name: entry.values[name].copy() for name in ("tc", "rc")}
            for code in codes.values():
                code[rows] = 0
            entry = replace(entry, values={**entry.values, **codes})
        found.append(entry)
    return found
