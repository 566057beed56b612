"""Runs with planted faults in the deck and in the solver, and the record of which faults are caught."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from vmharness.case import Case
from vmharness.case.deck import read_deck
from vmharness.round_off import ROUND_OFF
from vmharness.studies.faults import plant
from vmharness.studies.faults.deck_faults import (
    DECLARED,
    OTHER_SIGN,
    CaseFault,
    declared_faults,
    is_of_model,
    parameter_faults,
    support_faults,
)
from vmharness.studies.faults.record import FaultsRecord, Finding, Noticed
from vmharness.studies.faults.solver_fault import SolverFault
from vmharness.studies.maker import maker
from vmharness.studies.measured import Measured
from vmharness.studies.variant import Variant

BUILTIN = ("vmharness.explicit.", "vmharness.backends.builtin.")  # modules that no other solver runs
LONGEST = 3  # a run with a wrong unit ends after this multiple of the cycles of the sound run


class StudyError(Exception):
    """The study of a case cannot be made."""


def all_faults(case: Case, sound: Measured, solver: str = "builtin") -> list[CaseFault]:
    """Every fault to plant in a case that this solver runs; raises StudyError unless its `sound` run passes."""
    if not sound.passed:
        key = sound.worst[0] if sound.worst else "nothing"
        raise StudyError(f"{case.id}: the run without a fault does not pass: {sound.failure or key}")
    return [
        *parameter_faults(case, LONGEST * sound.cycles),
        *support_faults(case),
        *declared_faults(case),
        *solver_faults(case, solver),
    ]


def planted_in(solver: str) -> list[SolverFault]:
    """The faults that can be planted in a run by this solver: those of the built-in solver need the built-in solver."""
    return [fault for fault in plant.faults() if solver == "builtin" or not fault.module.startswith(BUILTIN)]


def solver_faults(case: Case, solver: str = "builtin") -> list[CaseFault]:
    """The faults of the solver, and of the reading of its results, that can change a run of this deck."""
    names = {entry.keyword.name for entry in read_deck(case).entries}
    return [
        CaseFault(fault.name, fault.text, fault.kind, Variant(case, fault.name, fault.digest))
        for fault in planted_in(solver)
        if not fault.keywords or any(name.startswith(fault.keywords) for name in names)
    ]


def record(
    case: Case,
    sound: Measured,
    faults: Sequence[CaseFault],
    outcomes: Sequence[Measured],
    solver: str = "builtin",
) -> FaultsRecord:
    """The record of all faults of a case; faults that its deck cannot show are not run, and count as unseen."""
    pairs = list(zip(faults, outcomes, strict=True))
    found = [finding(fault, sound, outcome) for fault, outcome in pairs if fault.kind != DECLARED]
    promised = {fault.name: outcome for fault, outcome in pairs if fault.kind == DECLARED}
    run = {fault.name for fault in faults}
    unseen = [fault for fault in planted_in(solver) if fault.name not in run]
    found += [Finding(fault.name, fault.text, fault.kind, Noticed.UNSEEN) for fault in unseen]
    idle = {name for name in case.file.deck.parameters if _is_idle(case, name, found)}
    found = [
        replace(one, noticed=Noticed.HARMLESS)
        if one.kind == "deck" and one.fault.partition(" ")[0] in idle and one.noticed is Noticed.MISSED
        else one
        for one in found
    ]
    own = [outcome for fault, outcome in pairs if fault.kind != "reading"]
    return FaultsRecord(
        case=case.id,
        case_sha256=case.inputs_sha256,
        findings=found,
        made_by=maker([sound]),
        unmoved=unmoved(sound, own),
        unproven=unproven(case, promised),
    )


def unproven(case: Case, outcomes: Mapping[str, Measured]) -> list[str]:
    """Sentences on declared faults, by their text, that do not fail what they must, or could not be judged."""
    sentences = []
    for fault in case.file.faults:
        outcome = outcomes.get(fault.text)
        if outcome is None or (outcome.failure and not outcome.lost):
            continue
        if outcome.lost:
            sentences.append(f"{fault.text}: could not be judged: {outcome.failure}")
            continue
        passed = [key for key in fault.must_fail if outcome.results[key].verdict == "pass"]
        sentences += [f"{fault.text}: {key} must fail, and passes" for key in passed]
    return sentences


def unmoved(sound: Measured, outcomes: Sequence[Measured]) -> list[str]:
    """Keys of results that have the value of the sound run, but for round-off, in every run that differs from it.

    Such a result reads what its event or the deck's input gives: it cannot disagree with its target.
    """
    others = [each for each in outcomes if each.results and not (each.failure or each.lost)]
    others = [each for each in others if each.history_sha256 != sound.history_sha256]
    return [key for key in sound.results if others and all(_same(sound, each, key) for each in others)]


def _same(sound: Measured, other: Measured, key: str) -> bool:
    """Whether a result has the same value in both runs but for round-off."""
    one, two = sound.results[key].value, other.results[key].value
    return one is not None and two is not None and abs(two - one) <= ROUND_OFF * abs(one)


def _is_idle(case: Case, name: str, found: Sequence[Finding]) -> bool:
    """Whether a parameter describes the model alone, and no change of it fails except that of its sign."""
    own = [one for one in found if one.kind == "deck" and one.fault.partition(" ")[0] == name]
    passed = [one.noticed is not Noticed.CAUGHT for one in own if one.fault != f"{name} {OTHER_SIGN}"]
    return is_of_model(case, f"parameter {name}") and all(passed)


def finding(fault: CaseFault, sound: Measured, outcome: Measured) -> Finding:
    """Whether a fault is caught, missed, without any effect or not judged.

    Raises StudyError if the fault could not be planted.
    """
    if outcome.lost:
        return Finding(fault.name, fault.text, fault.kind, Noticed.UNJUDGED, reason=outcome.failure)
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
