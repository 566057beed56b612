"""The difference: each result less its target, cause by cause; published columns likewise."""

from collections.abc import Sequence

import msgspec

from vmharness.case import Case
from vmharness.reading import last_cycles
from vmharness.report.blocks import Figure, Section, Table
from vmharness.report.figures import stacked
from vmharness.report.number import DASH, positional, share
from vmharness.studies.explain.record import Column, Explained, ExplainRecord

HOW = (
    "Value less target, in percent of the tolerance, cause by cause: time step and sampling from runs with half and a "
    "quarter of the step, read at the instants of this one and more finely; the numbers of the deck from a run with "
    "all those of the data; a penalty from a run with contacts twice as stiff; a mesh from what its refinement "
    "converges to. What is left is unexplained; ± is what the causes leave open."
)

SPLIT = "The last table splits its distance from theory into parts."


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm explain`."""
    found = msgspec.json.decode(content, type=ExplainRecord)
    return Section(
        "The difference, cause by cause",
        summary(found),
        text=[HOW],
        tables=[_table(found.results, "value")],
        remarks=remarks(found),
    )


def figures(content: bytes) -> list[Figure]:
    """Bars of the parts of the results."""
    found = msgspec.json.decode(content, type=ExplainRecord)
    caption = "Value less target, cause by cause, in percent of the tolerance; diamonds: the whole difference"
    return [_figure(found.case, "explained", caption, found.results, True)]


def columns(content: bytes, case: Case) -> dict[str, Section]:
    """What was found of each published column; drawn, too, where a solver gave it."""
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
    """The largest part that nothing explains, as a share of its tolerance."""
    rest = [_share(one, one.unexplained.value) for one in found.results]
    return f"{share(max(rest, default=0.0) / 100.0)} of a tolerance unexplained"


def tables(found: ExplainRecord) -> list[Table]:
    """A table for the results, and one for each published column."""
    return [_table(found.results, "value")] + [
        _table(column.results, column.name) for column in found.columns
    ]


def remarks(found: ExplainRecord) -> list[str]:
    """What was not separated."""
    return [f"{note[0].upper()}{note[1:]}." for note in found.notes]


def _table(results: Sequence[Explained], value: str) -> Table:
    """Parts in percent of the tolerance; of a published column in percent of the target, for it has no tolerance."""
    causes, own = _causes(results), value == "value"
    head = [f"Result (% of the {'tolerance' if own else 'target'})", f"{value} − target", *causes, "±"]
    return Table(head, [_row(one, causes, own) for one in results])


def _row(one: Explained, causes: Sequence[str], own: bool) -> list[str]:
    parts = {part.cause: part.value for part in one.parts}
    shown = [_percent(one, parts[cause], own) if cause in parts else DASH for cause in causes]
    open_ = _percent(one, one.unexplained.open, own).removeprefix("-")
    return [one.key, _percent(one, one.difference, own), *shown, open_]


def _column_figure(case: str, column: Column, number: int) -> Figure:
    caption = f"{column.name} less target, cause by cause, in percent of the target"
    return _figure(case, f"explained-{number}", caption, column.results, False)


def _figure(case: str, name: str, caption: str, results: Sequence[Explained], own: bool) -> Figure:
    bars = {one.key: {part.cause: _percent_of(one, part.value, own) for part in one.parts} for one in results}
    what = f"Percent of the {'tolerance' if own else 'target'}"
    return Figure(name, caption, stacked.draw(f"{case}-{name}", bars, _causes(results), what))


def _column_text(column: Column, case: Case) -> str:
    """What a published column seems to be; what the case says of it itself is not said again."""
    count = f"{len(column.same)} of {len(column.results)} figures"
    if column.kind == "target":
        odd = [one.key for one in column.results if one.key not in column.same]
        rest = f" Not so: {', '.join(odd)}." if odd else ""
        return f"{count} are the targets of this case, rounded.{rest}"
    unit = case.file.units.time
    declared = next(one for one in case.file.published if one.name == column.name)
    also = ", ".join(f"{interval:g} {unit}" for interval in column.also)
    same = declared.interval is not None and column.reading == last_cycles(declared.interval, unit)
    text = (
        f"Of all readings tried, {'this one' if same else column.reading} gives most of the column: {count}"
    )
    text += f"; {also} gives as many." if also else "."
    others = [
        f"{key} fits {reading}." for key, reading in column.others.items() if key not in declared.exactly_at
    ]
    return " ".join([text, *others, SPLIT])


def _causes(results: Sequence[Explained]) -> list[str]:
    """All causes in their order; what is unexplained comes last."""
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
