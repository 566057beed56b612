"""Runs of the levels of a refinement, and the record of their results."""

from collections.abc import Sequence

from vmharness.case import Case, CaseError
from vmharness.case.format import Converge
from vmharness.formula import Unit
from vmharness.studies.converge.record import ConvergeRecord, Level, refined
from vmharness.studies.maker import maker
from vmharness.studies.measured import Measured
from vmharness.studies.variant import Variant


def variants(case: Case) -> list[Variant]:
    """A variant for each level of [converge]; raises CaseError without [converge], or if a target changes."""
    found = []
    for number in _plan(case).levels:
        variant = case.with_given(_data(case, number))
        for result in case.file.results:
            target, moved = case.target(result.key), variant.target(result.key)
            if abs(moved - target) > 1e-9 * abs(target):
                raise CaseError(
                    f"{case.id}: [converge] N = {number:g} changes the target of {result.key}; a refinement must not"
                )
        found.append(Variant(variant, f"N = {number:g}"))
    return found


def record(case: Case, outcomes: Sequence[Measured]) -> ConvergeRecord:
    """The record of the levels' outcomes."""
    plan = _plan(case)
    found = []
    for number, outcome in zip(plan.levels, outcomes, strict=True):
        data = {
            name: value / case.units.factor(case.file.given[name].unit)
            for name, value in _data(case, number).items()
        }
        found.append(Level(number, _at(case, "size", number), data, outcome.cycles, outcome.failure))
    values = {
        result.key: [
            outcome.results[result.key].value if result.key in outcome.results else None
            for outcome in outcomes
        ]
        for result in case.file.results
    }
    dimension = case.formulas["converge size"].dimension({**case.dimensions, "N": Unit("").dimension})
    return ConvergeRecord(
        case=case.id,
        case_sha256=case.inputs_sha256,
        refined=plan.refined,
        size=plan.size,
        unit=case.units.name(dimension),
        held=plan.held,
        because=plan.because,
        levels=found,
        results=refined(case, [level.size for level in found], values),
        made_by=maker(outcomes),
    )


def _plan(case: Case) -> Converge:
    if case.file.converge is None:
        raise CaseError(f"{case.id}: case.toml has no [converge] table, which says what is refined")
    return case.file.converge


def _data(case: Case, number: float) -> dict[str, float]:
    return {name: _at(case, name, number) for name in _plan(case).set}


def _at(case: Case, name: str, number: float) -> float:
    """The value of a formula of [converge] at the level `number`; consistent units."""
    return float(case.formulas[f"converge {name}"].evaluate({**case.values, "N": number}))
