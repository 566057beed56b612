"""Planted faults as variants of a case, and what its results make of them.

Faults of the deck leave the theory alone: one parameter is wrong by a few percent, in its sign or in its unit, or a
support is missing. Those of the solver are planted in processes of their own (evidence/plant.py).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from vmharness.backends.builtin import read_deck
from vmharness.case import Case
from vmharness.deck import Deck, DeckError, Entry
from vmharness.evidence import plant
from vmharness.evidence.detection import Detection, Finding, Noticed
from vmharness.evidence.faults import RUN_LENGTH
from vmharness.study.deck import with_entries
from vmharness.study.measured import Measured
from vmharness.study.variant import Variant

PERCENTS = (0.1, -0.1, 1.0, -1.0, 5.0, -5.0)
SLIP = 1000.0  # between a unit and its thousandth
OTHER_SIGN = "of the other sign"  # which most decks must not have
MODEL = "Model"  # the group of the data that are no part of the problem
LONGEST = 3  # a wrong unit makes a run no more than so many times as long: it would only be waited for


class StudyError(Exception):
    """A study that cannot be made."""


@dataclass(frozen=True)
class Planted:
    """A fault in a case, before it is run."""

    name: str
    text: str
    kind: str
    variant: Variant


def planted(case: Case, sound: Measured) -> list[Planted]:
    """Every fault to plant in a case whose `sound` run is known; raises StudyError unless that passes."""
    if not sound.passed:
        key = sound.worst[0] if sound.worst else "nothing"
        raise StudyError(f"{case.id}: does not pass without any fault: {sound.failure or key}")
    return [*parameter_faults(case, LONGEST * sound.cycles), *support_faults(case), *solver_faults(case)]


def parameter_faults(case: Case, cycles: int) -> list[Planted]:
    """Each parameter of the deck that the problem sets, wrong alone; a wrong unit ends after so many `cycles`."""
    found = []
    for name, formula in case.file.deck.parameters.items():
        value = case.evaluate(f"parameter {name}")
        if formula == RUN_LENGTH or value == 0.0:
            continue
        wrong = {f"{percent:+g} %": value * (1.0 + percent / 100.0) for percent in PERCENTS}
        for how, other in {**wrong, OTHER_SIGN: -value}.items():
            found.append(_deck_fault(f"{name} {how}", _with_parameter(case, name, other)))
        slipped = _ended(_with_parameter(case, name, SLIP * value), cycles)
        found.append(_deck_fault(f"{name} {SLIP:g} times as large", slipped))
    return found


def support_faults(case: Case) -> list[Planted]:
    """Without the last support of the deck, and without any."""
    deck = read_deck(case)
    supports = [entry for entry in deck.entries if entry.keyword.name.startswith("BOUNDARY_SPC")]
    coded = [entry for entry in deck.all("NODE") if (entry.tc | entry.rc).any()]
    if not supports and not coded:
        return []
    none = with_entries(case, lambda deck: _without_supports(deck, last=False))
    last = with_entries(case, lambda deck: _without_supports(deck, last=True))
    return [_deck_fault("the last support is missing", last), _deck_fault("all supports are missing", none)]


def solver_faults(case: Case) -> list[Planted]:
    """The faults of the solver that the deck has something of."""
    names = {entry.keyword.name for entry in read_deck(case).entries}
    return [
        Planted(fault.name, fault.text, fault.kind, Variant(case, fault.name, fault.digest))
        for fault in plant.faults()
        if not fault.keywords or any(name.startswith(fault.keywords) for name in names)
    ]


def detection(
    case: Case, sound: Measured, faults: Sequence[Planted], outcomes: Sequence[Measured], solver: str
) -> Detection:
    """What the results of a case make of each fault, and of those that its deck has nothing of, which are not run."""
    found = [finding(fault, sound, outcome) for fault, outcome in zip(faults, outcomes, strict=True)]
    run = {fault.name for fault in faults}
    unseen = [fault for fault in plant.faults() if fault.name not in run]
    found += [Finding(fault.name, fault.text, fault.kind, Noticed.UNSEEN) for fault in unseen]
    idle = {name for name in case.file.deck.parameters if _is_idle(case, name, found)}
    found = [
        replace(one, noticed=Noticed.HARMLESS)
        if one.kind == "deck" and one.fault.partition(" ")[0] in idle and one.noticed is Noticed.MISSED
        else one
        for one in found
    ]
    return Detection(case.id, case.sha256, solver, found)


def _is_idle(case: Case, name: str, found: Sequence[Finding]) -> bool:
    """Whether a parameter is of the model alone, and every change of it passes, the wrong unit included."""
    data = case.origins(f"parameter {name}")
    if not all(case.file.given[datum].group == MODEL for datum in data):
        return False
    own = [one for one in found if one.kind == "deck" and one.fault.partition(" ")[0] == name]
    return all(one.noticed is not Noticed.CAUGHT or one.fault == f"{name} {OTHER_SIGN}" for one in own)


def finding(fault: Planted, sound: Measured, outcome: Measured) -> Finding:
    """Caught, missed, or the same to the last bit; raises StudyError where the fault could not be planted."""
    if outcome.failure.startswith("defect: "):
        raise StudyError(f"{fault.name}: {outcome.failure}")
    found = Finding(fault.name, fault.text, fault.kind, Noticed.CAUGHT)
    if outcome.failure:
        return replace(found, reason=outcome.failure)
    key, share = outcome.worst or ("", np.inf)
    by = replace(found, by=key, share=float(f"{share:.3g}") if np.isfinite(share) else None)
    if not outcome.passed:
        wrong = next(value for value in outcome.results.values() if value.verdict != "pass")
        return by if by.share is not None else replace(by, reason=outcome.results[key].reason or wrong.reason)
    same = (outcome.history_sha256, outcome.results) == (sound.history_sha256, sound.results)
    return replace(found, noticed=Noticed.UNSEEN) if same else replace(by, noticed=Noticed.MISSED)


def _deck_fault(name: str, case: Case) -> Planted:
    return Planted(name, f"In the deck, {name}", "deck", Variant(case, name))


def _with_parameter(case: Case, name: str, value: float) -> Case:
    return replace(case, planted={**case.deck_parameters(), name: value})


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


def _without_supports(deck: Deck, last: bool) -> list[Entry]:
    """The entries without their last support, or without all of them: those of *BOUNDARY_SPC before those of *NODE."""
    places = [
        (entry, row)
        for entry in deck.entries
        for row in (
            np.flatnonzero(entry.tc | entry.rc).tolist()
            if entry.keyword.name == "NODE"
            else [-1] * entry.keyword.name.startswith("BOUNDARY_SPC")
        )
    ]
    places.sort(key=lambda place: place[1] < 0)
    gone = places[-1:] if last else places
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
