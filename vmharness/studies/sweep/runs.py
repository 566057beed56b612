"""Runs of a case at the points of a sweep, and the record of their results."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from vmharness.case import Case, CaseError
from vmharness.case.format import Sweep
from vmharness.case.settings import as_options, with_settings
from vmharness.formula import FormulaError
from vmharness.round_off import largest, rounded
from vmharness.studies.maker import maker
from vmharness.studies.measured import Measured, Value
from vmharness.studies.sweep import sampling
from vmharness.studies.sweep.record import Failing, SweepRecord, Worst, worst_share
from vmharness.studies.sweep.sampling import Point
from vmharness.studies.sweep.shrink import shrink
from vmharness.studies.variant import Variant

SIMPLER = "simpler points that may fail"
SHARE_DIGITS = 4
MOST = 100_000  # points of a grid, before the constraints: more would run for days
Gather = Callable[[Sequence[Variant], str], Sequence[Measured]]  # runs variants; the text is their purpose


def points(case: Case, count: int | None, seed: int, grid: int | None) -> tuple[list[Point], str]:
    """The points of the sweep, each datum in its unit, and how they were chosen, in words.

    A `grid` has that many values of each datum. Raises CaseError if no point meets the constraints, or a grid has more
    than MOST points.
    """
    plan = plan_of(case)
    if grid is not None:
        if (size := grid ** len(plan.ranges)) > MOST:
            raise CaseError(
                f"{case.id}: a grid of {grid} values of {len(plan.ranges)} data has {size:.2g} points, "
                f"more than {MOST}; use -n N for a Latin hypercube of N points"
            )
        found = [point for point in sampling.grid(plan.ranges, grid) if _accepted(case, plan, point)]
        how = f"{len(found)} points of a grid with {grid} values of each datum"
    else:
        wanted = count or plan.points
        found = sampling.sampled(plan.ranges, wanted, seed, lambda point: _accepted(case, plan, point))
        how = f"{len(found)} points of a Latin hypercube, seed {seed}"
    if not found:
        raise CaseError(f"{case.id}: [sweep]: no point of the region meets the constraints")
    return found, how


def record(case: Case, found: Sequence[Point], how: str, gather: Gather, again: str = "") -> SweepRecord:
    """The record of all points; the worst failing point is made simpler. `gather` runs variants.

    `again` is the command that runs the case.
    """
    plan = plan_of(case)
    outcomes = measure(case, found, gather, "sweep")
    labels = {result.key: result.label for result in case.file.results}
    record = SweepRecord(
        case=case.id,
        case_sha256=case.inputs_sha256,
        how=how,
        ranges=dict(plan.ranges),
        units={name: case.file.given[name].unit for name in plan.ranges},
        within=[f"{each.low:g} ≤ {each.formula} ≤ {each.high:g}: {each.because}" for each in plan.within],
        data={name: [point[name] for point in found] for name in plan.ranges},
        shares={key: [_share(outcome, key) for outcome in outcomes] for key in labels},
        results=[_worst(key, label, found, outcomes) for key, label in labels.items()],
        unjudged={number: outcome.failure for number, outcome in enumerate(outcomes) if outcome.failure},
        failing=None,
        made_by=maker(outcomes),
    )
    return replace(record, failing=_shrunk(case, record, found, gather, again)) if record.failed else record


def measure(case: Case, found: Sequence[Point], gather: Gather, what: str) -> list[Measured]:
    """The outcome at each point; a point where theory has no value is a failure."""
    variants: dict[int, Variant] = {}
    outcomes: dict[int, Measured] = {}
    for number, point in enumerate(found):
        try:
            variants[number] = Variant(with_settings(case, settings(case, point)))
        except CaseError as error:
            outcomes[number] = Measured(failure=str(error))
    outcomes |= dict(zip(variants, gather(list(variants.values()), what), strict=True))
    return [outcomes[number] for number in range(len(found))]


def settings(case: Case, point: Point) -> Point:
    """The data of a point, and those that follow from them to six digits, each in its unit."""
    plan = plan_of(case)
    there = with_settings(case, point) if point else case
    follow = {}
    for name in plan.set:
        unit = case.units.factor(case.file.given[name].unit)
        follow[name] = rounded(there.evaluate(f"sweep {name}") / unit, 6)
    return {**point, **follow}


def plan_of(case: Case) -> Sweep:
    """[sweep] of the case; raises CaseError without one."""
    if case.file.sweep is None:
        raise CaseError(f"{case.id}: case.toml has no [sweep] table, which gives the ranges of the data")
    return case.file.sweep


def _accepted(case: Case, plan: Sweep, point: Point) -> bool:
    """Whether a point meets all constraints that have a value there; the others are reported later."""
    factors = {name: case.units.factor(case.file.given[name].unit) for name in point}
    known = {**case.given, **{name: value * factors[name] for name, value in point.items()}}
    for name in case.file.theory:
        if (value := _value(case, name, known)) is not None:
            known[name] = value
    values = [_value(case, f"within {number}", known) for number in range(1, len(plan.within) + 1)]
    return all(
        value is None or each.low <= value <= each.high
        for each, value in zip(plan.within, values, strict=True)
    )


def _value(case: Case, name: str, known: Point) -> float | None:
    """The value of a formula; None if it has none for these data."""
    formula = case.formulas[name]
    if not formula.names <= known.keys():
        return None
    try:
        return float(formula.evaluate(known))
    except FormulaError:
        return None


def _share(outcome: Measured, key: str) -> float | None:
    return _used(outcome.results[key]) if key in outcome.results else None


def _used(value: Value) -> float | None:
    """The share of a tolerance, to few digits if it is not exceeded; none of it where the error is round-off."""
    if value.share is None or value.verdict != "pass":
        return value.share
    return 0.0 if value.is_round_off else rounded(value.share, SHARE_DIGITS)


def _worst(key: str, label: str, found: Sequence[Point], outcomes: Sequence[Measured]) -> Worst:
    """The point with the largest share, among those with a verdict."""
    judged = [i for i, outcome in enumerate(outcomes) if not outcome.failure]
    results = {i: outcomes[i].results[key] for i in judged}
    failed = sum(value.verdict != "pass" for value in results.values())
    if not judged:
        return Worst(key, label, None, None, {}, 0)
    i = largest(judged, lambda i: _size(_used(results[i])))
    error = 0.0 if results[i].is_round_off else results[i].error
    return Worst(key, label, _used(results[i]), error, dict(found[i]), failed)


def _shrunk(case: Case, record: SweepRecord, found: Sequence[Point], gather: Gather, command: str) -> Failing:
    """The worst failing point, and the simplest point at which the same result fails."""
    worst = largest(record.failed, lambda i: worst_share(record, i))
    key = largest(record.shares, lambda key: _size(record.shares[key][worst]))
    plan = plan_of(case)

    def fails(attempts: Sequence[Point]) -> list[bool]:
        kept = [_accepted(case, plan, attempt) for attempt in attempts]
        tried = [attempt for attempt, keep in zip(attempts, kept, strict=True) if keep]
        outcomes = iter(measure(case, tried, gather, SIMPLER))
        return [keep and _fails(next(outcomes), key) for keep in kept]

    simpler = shrink(found[worst], {name: case.datum(name) for name in found[worst]}, fails)
    (last,) = measure(case, [simpler], gather, SIMPLER)
    again = f"{command or f'vm run {case.id}'} {as_options(settings(case, simpler))}"
    return Failing(dict(found[worst]), simpler, f"{key}: {last.results[key].reason}", again)


def _fails(outcome: Measured, key: str) -> bool:
    return not outcome.failure and outcome.results[key].verdict != "pass"


def _size(share: float | None) -> float:
    return float("inf") if share is None else share
