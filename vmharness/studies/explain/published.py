"""Published columns explained by a reading of states and by the rounding of the printed digits."""

from decimal import Decimal

from vmharness.case import Case
from vmharness.case.format import Published
from vmharness.formula import Unit
from vmharness.history import History
from vmharness.studies.explain import readings
from vmharness.studies.explain.record import SAMPLING, Column, Explained, Part, explained

SOLVER, ROUNDING = "this solver", "printed digits"


def columns(case: Case, history: History) -> list[Column]:
    """Every published column of the case; for a column that a solver computed, the best reading of the history."""
    return [
        _computed(case, history, column) if column.kind == "computed" else _target(case, column)
        for column in case.published
    ]


def half_unit(text: str) -> float:
    """Half a unit of the last printed digit.

    >>> half_unit("-1.0005"), half_unit("193")
    (5e-05, 0.5)
    """
    return 0.5 * 10.0 ** int(Decimal(text).as_tuple().exponent)


def _computed(case: Case, history: History, column: Published) -> Column:
    plain, best = readings.plain(case, history, column), readings.best(case, history, column)
    other = readings.rest(case, history, column, best) if best.interval else None
    unit = case.file.units.time
    results = []
    for key, text in column.values.items():
        used = other if other is not None and key in other.same else best
        if key not in used.values or key not in plain.values:
            continue
        value, read = plain.values[key], used.values[key]
        parts = [Part(SOLVER, value - _theory(case, key)), Part(SAMPLING, read - value)]
        results.append(_explained(case, key, text, read, parts))
    return Column(
        name=column.name,
        kind=column.kind,
        reading=best.says(unit),
        also=list(best.also),
        same=list(best.same),
        others=dict.fromkeys(other.same, other.says(unit)) if other else {},
        results=results,
    )


def _target(case: Case, column: Published) -> Column:
    """A column of targets: a difference larger than the rounding comes from another theory or from other data."""
    results = [_explained(case, key, text, _theory(case, key), []) for key, text in column.values.items()]
    same = [one.key for one in results if one.unexplained.value == 0.0]
    return Column(column.name, column.kind, "", [], same, {}, results)


def _explained(case: Case, key: str, text: str, read: float, parts: list[Part]) -> Explained:
    """The error of the figure `text`, of which `read` is the exact value if they differ by half a unit at most."""
    result, target, published, half = case.result(key), _theory(case, key), float(text), half_unit(text)
    rounds = abs(published - read) <= half * (1.0 + 1e-9)
    rounding = Part(ROUNDING, published - read if rounds else 0.0, 0.0 if rounds else half, "bound")
    tolerance = result.tolerance
    allowed = tolerance.absolute + tolerance.relative * abs(target)
    return explained(key, result.label, result.unit, target, published, allowed, [*parts, rounding])


def _theory(case: Case, key: str) -> float:
    return case.target(key) / case.units.factor(Unit(case.result(key).unit))
