"""Computed history and theory on a common grid of time, for drawing."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from vmharness.case import Case
from vmharness.case.format import as_line
from vmharness.case.tolerance import allowed_difference
from vmharness.formula import Unit
from vmharness.history import History
from vmharness.result import CaseRun

Array = NDArray[np.float64]
POINTS = 361


@dataclass(frozen=True)
class Curve:
    """One channel in the unit that it is drawn in: computed and theory (n,) at the same times (n,), in `time_unit`."""

    channel: str
    label: str
    unit: str
    time: Array
    computed: Array
    theory: Array
    residual: Array
    allowed: Mapping[str, tuple[float, float]]  # by key of a result: time of its event, allowed difference


def curves(run: CaseRun) -> list[list[Curve]]:
    """The channels with theory over time, grouped by unit: one list for each figure."""
    history = run.solution.history
    if history is None or len(history) < 3:
        return []
    all_ = [_curve(run, history, name) for name in run.case.file.curves if name in history]
    return [list(group) for _, group in groupby(all_, key=lambda curve: curve.unit)]


def _curve(run: CaseRun, history: History, name: str) -> Curve:
    line = as_line(run.case.file.curves[name])
    unit = _unit(run.case, name)
    factor = run.case.units.factor(Unit(unit))
    sampled = history.time_of(name)
    time = np.linspace(sampled[0], sampled[-1], POINTS)
    computed, theory = history.at(name, time) / factor, run.case.curve(name, time) / factor
    size = float(np.abs(theory).max())
    allowed = _allowed(run, name, factor)
    # Differences far below what is allowed are round-off; drawn, they would be noise that no two machines share.
    finest = max([1e-9 * size, *(1e-3 * difference for _, difference in allowed.values())])
    return Curve(
        channel=name,
        label=line.text or name,
        unit=unit,
        time=time / time_factor(run.case),
        computed=_rounded(computed, 1e-6 * size),
        theory=_rounded(theory, 1e-6 * size),
        residual=_rounded(computed - theory, finest),
        allowed=allowed,
    )


def time_unit(case: Case) -> str:
    """The unit of the time axis: that of the first result that is a time, or the consistent one."""
    return next(
        (result.unit for result in case.file.results if result.channel == "time"), case.file.units.time
    )


def time_factor(case: Case) -> float:
    """How many consistent units the unit of the time axis is."""
    return case.units.factor(Unit(time_unit(case)))


def _unit(case: Case, name: str) -> str:
    """The unit to draw a curve in: the declared one, that of results, first of the channel, or the consistent one."""
    line = as_line(case.file.curves[name])
    if line.unit is not None:
        return line.unit
    time = Unit(case.file.units.time).dimension
    dimension = case.formulas[f"curve {name}"].dimension({**case.dimensions, "t": time})
    own_first = sorted(case.file.results, key=lambda result: result.channel != name)
    alike = [result.unit for result in own_first if Unit(result.unit).dimension == dimension]
    return alike[0] if alike else case.units.name(dimension)


def _allowed(run: CaseRun, channel: str, factor: float) -> dict[str, tuple[float, float]]:
    """Times and sizes of the allowed differences by the results of the channel, in a unit of the size `factor`."""
    allowed = {}
    for row in run.rows:
        result = run.case.result(row.key)
        event = run.events.get(result.event)
        if result.channel == channel and event is not None and not isinstance(event, str):
            time = event.time / time_factor(run.case)
            allowed[row.key] = (time, allowed_difference(run.case, row.key) / factor)
    return allowed


def _rounded(values: Array, step: float) -> Array:
    """Multiples of `step`, without negative zeros."""
    return np.round(values / step) * step + 0.0 if step > 0.0 else values
