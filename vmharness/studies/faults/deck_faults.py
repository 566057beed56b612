"""Faults of the deck as variants of its case; the theory and the targets do not change.

One number is wrong by a few percent, in its sign or in its unit; or supports are missing.
"""

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from vmharness.case import Case, CaseError
from vmharness.case.deck import read_deck
from vmharness.case.format import RUN_LENGTH
from vmharness.case.template import MOST
from vmharness.deck import Deck, DeckError, Entry
from vmharness.studies.changed_deck import with_entries
from vmharness.studies.faults.declared import faulty_data
from vmharness.studies.variant import Variant

PERCENTS = (0.1, -0.1, 1.0, -1.0, 5.0, -5.0)
OTHER_SIGN = "with the opposite sign"
SLIP = 1000.0  # factor of a wrong unit
LARGEST = 20  # a wrong unit may make the deck at most so many times as long: a longer run is not waited for
DECLARED = "declared"  # kind of a fault that the case declares
MODEL = "Model"  # group of the data of the model, which are not data of the problem


@dataclass(frozen=True)
class CaseFault:
    """A fault to plant, and the variant of the case that has it."""

    name: str
    text: str
    kind: str
    variant: Variant


def parameter_faults(case: Case, cycles: int) -> list[CaseFault]:
    """Faults of each parameter of the deck, one at a time; a run with a wrong unit ends after `cycles` cycles.

    The mesh parameters of a template that describe the model alone are skipped: they count nodes and elements.
    """
    deck = case.file.deck
    most = LARGEST * len(case.deck_source()) or MOST
    found: list[CaseFault] = []
    for name, formula in deck.parameters.items():
        if formula != RUN_LENGTH:
            found += _wrong(name, case.evaluate(f"parameter {name}"), _parameter(case, name), cycles, most)
    for name, value in case.mesh_parameters().items():
        if not is_of_model(case, f"mesh {name}"):
            found += _wrong(name, value, _mesh(case, name), cycles, most)
    return found


def declared_faults(case: Case) -> list[CaseFault]:
    """The faults that the case declares, in its deck alone."""
    return [
        CaseFault(
            fault.text, fault.text, DECLARED, Variant(case.with_deck_of(faulty_data(case, fault)), fault.text)
        )
        for fault in case.file.faults
    ]


def support_faults(case: Case) -> list[CaseFault]:
    """Two faults: the last support is missing, and all supports are missing."""
    if not _supports(read_deck(case)):
        return []
    none = with_entries(case, lambda deck: _without(deck, _supports(deck)))
    last = with_entries(case, lambda deck: _without(deck, _supports(deck)[-1:]))
    return [_fault("the last support is missing", last), _fault("all supports are missing", none)]


def is_of_model(case: Case, formula: str) -> bool:
    """Whether a formula depends on data of the model alone, and on none of the problem."""
    return all(case.file.given[datum].group == MODEL for datum in case.origins(formula))


def _fault(name: str, case: Case) -> CaseFault:
    return CaseFault(name, f"Deck: {name}", "deck", Variant(case, name))


def _wrong(
    name: str, value: float, make: Callable[[float], Case], cycles: int, most: float
) -> Iterator[CaseFault]:
    """The faults of a number that is not zero, as far as the template makes a deck of at most `most` characters."""
    if value == 0.0:
        return
    changes = [(f"{percent:+g} %", 1.0 + percent / 100.0) for percent in PERCENTS]
    for text, factor in [*changes, (OTHER_SIGN, -1.0), (f"{SLIP:g} times as large", SLIP)]:
        with suppress(CaseError):
            case = make(factor * value)
            case.deck_source(most)  # raises CaseError if the template makes no such deck
            yield _fault(f"{name} {text}", _ended(case, cycles) if factor == SLIP else case)


def _parameter(case: Case, name: str) -> Callable[[float], Case]:
    return lambda value: replace(case, overrides={**case.deck_parameters(), name: value})


def _mesh(case: Case, name: str) -> Callable[[float], Case]:
    return lambda value: replace(case, mesh_overrides={**case.mesh_overrides, name: value})


def _ended(case: Case, cycles: int) -> Case:
    """The case with a limit of `cycles`; a deck that cannot be read stays as it is, and the solver refuses it."""

    def change(entry: Entry) -> Entry:
        if entry.keyword.name != "CONTROL_TERMINATION":
            return entry
        return replace(entry, values={**entry.values, "endcyc": entry.endcyc or cycles})

    try:
        return with_entries(case, lambda deck: map(change, deck.entries))
    except DeckError:
        return case


def _supports(deck: Deck) -> list[tuple[Entry, int]]:
    """Each support as its entry and row: nodes with a constraint code, then entries of *BOUNDARY_SPC with row -1."""
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
