"""Section on the causes of the error of each result, and of published columns."""

from collections.abc import Sequence

import msgspec

from vmharness.case import Case
from vmharness.reading import last_cycles
from vmharness.report.blocks import Figure, Section, Table
from vmharness.report.figures import stacked
from vmharness.report.number import DASH, positional, share
from vmharness.studies.explain.record import Column, Explained, ExplainRecord

HOW = (
    "The error of each result (value − target) is split into its causes, in percent of the tolerance. Time step and "
    "sampling are found by runs with a half and a quarter of the time step, which are read at the times of this run "
    "and at finer times. Rounding of the deck is found by a run whose deck has all digits of the data; the contact "
    "penalty by a run with contacts twice as stiff; the mesh by the value to which its refinement converges. The last "
    "column is the rest that these causes do not explain, ± the sum of their uncertainties; a dash: there is none."
)

SPLIT = "The last table splits the error of each figure into its causes."


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm explain`."""
    found = msgspec.json.decode(content, type=ExplainRecord)
    return Section(
        "Causes of the error",
        summary(found),
        text=[HOW],
        tables=[_table(found.results, "value")],
        remarks=remarks(found),
    )


def figures(content: bytes) -> list[Figure]:
    """Bars: the error of each result by cause."""
    found = msgspec.json.decode(content, type=ExplainRecord)
    caption = "Error of each result by cause, in percent of the tolerance; diamonds: the whole error"
    return [_figure(found.case, "explained", caption, found.results, True)]


def columns(content: bytes, case: Case) -> dict[str, Section]:
    """The findings on each published column, with a drawing if a solver computed it."""
    found = msgspec.json.decode(content, type=ExplainRecord)
    return {
        column.name: Section(
            column.name,
            "",
            text=[_column_text(column, case)],
            tables=[_table(column.results, column.name)],
            figures=[_column_figure(found.case, column, number)] if column.kind == "computed" else [],
        )
        for number, column in enumerate(found.columns, 1)
    }


def summary(found: ExplainRecord) -> str:
    """The largest unexplained part of an error, as a share of its tolerance."""
    rest = [_share(one, one.unexplained.value) for one in found.results]
    return f"{share(max(rest, default=0.0) / 100.0)} of a tolerance is unexplained"


def tables(found: ExplainRecord) -> list[Table]:
    """A table for the results, and one for each published column."""
    return [_table(found.results, "value")] + [
        _table(column.results, column.name) for column in found.columns
    ]


def remarks(found: ExplainRecord) -> list[str]:
    """The causes that could not be separated."""
    return [f"{note[0].upper()}{note[1:]}." for note in found.notes]


def _table(results: Sequence[Explained], value: str) -> Table:
    """Parts in percent of the tolerance; for a published column, which has none, in percent of the target."""
    causes, own = _causes(results), value == "value"
    head = [f"Result (% of the {'tolerance' if own else 'target'})", f"{value} − target", *causes]
    return Table(head, [_row(one, causes, own) for one in results])


def _row(one: Explained, causes: Sequence[str], own: bool) -> list[str]:
    parts = {part.cause: part.value for part in one.parts}
    shown = [_percent(one, parts[cause], own) if cause in parts else DASH for cause in causes[:-1]]
    return [one.key, _percent(one, one.difference, own), *shown, _rest(one, own)]


def _rest(one: Explained, own: bool) -> str:
    """The unexplained rest with its uncertainty; a dash if nothing is left to explain."""
    rest = _percent(one, one.unexplained.value, own)
    open_ = _percent(one, one.unexplained.open, own).removeprefix("-")
    if open_ == "0":
        return DASH if rest == "0" else rest
    return f"{rest} ± {open_}"


def _column_figure(case: str, column: Column, number: int) -> Figure:
    caption = f"Error of the {column.name} column by cause, in percent of the target"
    return _figure(case, f"explained-{number}", caption, column.results, False)


def _figure(case: str, name: str, caption: str, results: Sequence[Explained], own: bool) -> Figure:
    bars = {one.key: {part.cause: _percent_of(one, part.value, own) for part in one.parts} for one in results}
    what = f"Percent of the {'tolerance' if own else 'target'}"
    return Figure(name, caption, stacked.draw(f"{case}-{name}", bars, _causes(results), what))


def _column_text(column: Column, case: Case) -> str:
    """The origin of a published column; remarks of the case itself are not repeated."""
    count = f"{len(column.same)} of {len(column.results)} figures"
    if column.kind == "target":
        odd = [one.key for one in column.results if one.key not in column.same]
        rest = f" These do not: {', '.join(odd)}." if odd else ""
        return f"{count} equal the rounded targets of this case.{rest}"
    unit = case.file.units.time
    declared = next(one for one in case.file.published if one.name == column.name)
    also = ", ".join(f"{interval:g} {unit}" for interval in column.also)
    same = declared.interval is not None and column.reading == last_cycles(declared.interval, unit)
    reading = "this one" if same else f"the following one ({column.reading})"
    text = f"Of all ways of reading that were tried, {reading} gives the most figures of the column: {count}."
    text += f" An interval of {also} gives as many." if also else ""
    others = [
        f"{key} agrees with another reading: {reading}."
        for key, reading in column.others.items()
        if key not in declared.exactly_at
    ]
    return " ".join([text, *others, SPLIT])


def _causes(results: Sequence[Explained]) -> list[str]:
    """All causes in their order; the unexplained rest comes last."""
    found = dict.fromkeys(part.cause for one in results for part in one.parts[:-1])
    return [*found, "unexplained"]


def _share(one: Explained, value: float) -> float:
    return abs(_percent_of(one, value, True))


def _percent_of(one: Explained, value: float, own: bool) -> float:
    whole = one.allowed if own else one.target
    return 100.0 * value / whole if whole else 0.0


def _percent(one: Explained, value: float, own: bool) -> str:
    percent = _percent_of(one, value, own)
    return positional(percent, 3 if own else 2) if abs(percent) >= (0.01 if own else 1e-5) else "0"
