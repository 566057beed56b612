"""Content of the page of a case, the same for every format."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from vmharness.case import Case, CaseError
from vmharness.case.format import Budget, Fault, Given, Line, as_line
from vmharness.case.tolerance import budget_lines, review_measured
from vmharness.formula import Formula, Unit
from vmharness.report import published
from vmharness.report.blocks import Figure, Section
from vmharness.report.figures import histories, model
from vmharness.report.figures.curves import Curve, curves
from vmharness.report.prose import sections
from vmharness.report.records import Studies
from vmharness.report.solver import short_name
from vmharness.result import CaseRun, Row
from vmharness.round_off import largest
from vmharness.studies.faults.declared import Move, moves
from vmharness.studies.sensitivity import Sensitivity, sensitivities


@dataclass(frozen=True)
class Datum:
    """A given datum, with its text."""

    name: str
    value: float  # in its own unit
    unit: str
    text: str


@dataclass(frozen=True)
class TheoryLine:
    """A line of the theory; the value is None for a curve over time."""

    name: str
    text: str
    formula: Formula
    value: float | None
    unit: Unit


@dataclass(frozen=True)
class PlantedFault:
    """A declared fault, and the change by theory of each result that must fail."""

    fault: Fault
    moves: Mapping[str, Move | None]  # by key; None where theory cannot say


@dataclass(frozen=True)
class Page:
    """The content of a page, for every format."""

    run: CaseRun
    solver: str  # without its version, which would change the page with every release
    prose: Mapping[str, str]  # Markdown, by title of the section
    data: Mapping[str, list[Datum]]  # by column of the data table
    theory: list[TheoryLine]
    curves: list[TheoryLine]
    groups: list[tuple[str, list[Row]]]  # rows of the results by title of their event
    budget: list[tuple[Budget, Mapping[str, float]]]  # each line, with its fractions of the targets by key
    doubtful: list[str]  # of the tolerances, in view of the errors of this run
    faults: list[PlantedFault]
    sensitivity: Mapping[str, Mapping[str, Sensitivity]]  # by datum, then by key of the result
    model: Figure | None
    histories: list[Figure]
    published: Mapping[str, Section]  # by name of the column
    studies: Sequence[Section]
    volatile: bool  # whether what varies from run to run may be shown
    indexed: bool  # whether an index lies in the folder above


def page(run: CaseRun, volatile: bool = True, indexed: bool = False, studies: Studies | None = None) -> Page:
    """The content of the page of a run; figures are drawn here, once for all formats."""
    studies = studies or Studies()
    case, solver = run.case, short_name(run.solution.solver)
    return Page(
        run=run,
        solver=solver,
        prose=sections(case),
        data=_data(case),
        theory=_theory(case),
        curves=_curves(case),
        groups=run.groups,
        budget=budget_lines(case),
        doubtful=review_measured(case, _errors(run)),
        faults=[_fault(case, fault) for fault in case.file.faults],
        sensitivity=sensitivities(case),
        model=_model(run),
        histories=_histories(run, solver),
        published=published.sections(run, studies.columns),
        studies=studies.sections,
        volatile=volatile,
        indexed=indexed,
    )


def worst_row(run: CaseRun) -> Row | None:
    """The result that uses most of its tolerance; of several the first."""
    judged = [row for row in run.rows if row.used is not None]
    return largest(judged, lambda row: row.used or 0.0) if judged else None


def _errors(run: CaseRun) -> dict[str, float]:
    """Errors as fractions of the targets, for the results that have one."""
    percents = {row.key: row.comparison.error_percent for row in run.rows}
    return {key: percent / 100.0 for key, percent in percents.items() if percent is not None}


def _data(case: Case) -> dict[str, list[Datum]]:
    columns: dict[str, list[Datum]] = {}
    for name, given in case.file.given.items():
        columns.setdefault(given.group, []).append(_datum(case, name, given))
    return columns


def _datum(case: Case, name: str, given: Given) -> Datum:
    return Datum(name, case.datum(name), given.unit, given.text)


def _theory(case: Case) -> list[TheoryLine]:
    lines = []
    for name, line in case.file.theory.items():
        line = as_line(line)
        unit = Unit(_unit(case, name, line))
        value = case.theory[name] / case.units.factor(unit)
        lines.append(TheoryLine(name, line.text, case.formulas[name], value, unit))
    return lines


def _unit(case: Case, name: str, line: Line) -> str:
    """The unit to print a line in: that of the result whose target it is, the declared one, or the consistent one."""
    units = [result.unit for result in case.file.results if result.target.strip() == name]
    declared = [] if line.unit is None else [line.unit]
    return next(iter([*units, *declared, case.units.name(case.dimensions[name])]))


def _curves(case: Case) -> list[TheoryLine]:
    return [
        TheoryLine(name, as_line(line).text, case.formulas[f"curve {name}"], None, Unit(""))
        for name, line in case.file.curves.items()
    ]


def _fault(case: Case, fault: Fault) -> PlantedFault:
    try:
        return PlantedFault(fault, moves(case, fault))
    except CaseError:
        return PlantedFault(fault, dict.fromkeys(fault.must_fail))


def _model(run: CaseRun) -> Figure | None:
    if run.solution.view is None:
        return None
    drawing = model.draw(run.solution.view, run.case.id, _acceleration(run.case))
    return Figure("model", f"The model as read from {run.case.deck_name}", drawing)


def _acceleration(case: Case) -> str:
    """The consistent unit of acceleration."""
    return case.units.name(Unit(f"{case.file.units.length}/{case.file.units.time}2").dimension)


def _histories(run: CaseRun, solver: str) -> list[Figure]:
    return [_history(run, together, solver) for together in curves(run)]


def _history(run: CaseRun, together: list[Curve], solver: str) -> Figure:
    name = "-".join(["history", *(curve.channel for curve in together)])
    quantity = histories.quantity(run, together)
    caption = f"{quantity} over time: {solver} (lines) and theory (hollow marks); below, their difference"
    if any(curve.allowed for curve in together):
        caption += " and the tolerance of each result at its event"
    return Figure(name, caption, histories.draw(run, name, together, solver))
