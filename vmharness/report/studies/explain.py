"""The difference: each result less its target, cause by cause; published columns likewise."""

from collections.abc import Sequence

import msgspec

from vmharness.case import Case
from vmharness.evidence.explanation import Column, Explained, Explanation
from vmharness.report.figures import stacked
from vmharness.report.number import DASH, positional, share
from vmharness.report.section import Figure, Section, Table

HOW = (
    "Value less target, in percent of the tolerance, cause by cause: time step and sampling from runs with half and a "
    "quarter of the step, read at the instants of this one and more finely; the numbers of the deck from a run with "
    "all those of the data; a penalty from a run with contacts twice as stiff; a mesh from what its refinement "
    "converges to. What is left is unexplained; ± is what the causes leave open."
)


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm explain`."""
    found = msgspec.json.decode(content, type=Explanation)
    return Section(
        "The difference, cause by cause",
        summary(found),
        text=[HOW, *(text for column in found.columns for text in _column_text(column, case))],
        tables=tables(found),
        remarks=remarks(found),
    )


def figures(content: bytes) -> list[Figure]:
    """Bars of the parts: of the results, and of each column that a solver gave."""
    found = msgspec.json.decode(content, type=Explanation)
    bars = {
        one.key: {part.cause: _percent_of(one, part.value, True) for part in one.parts}
        for one in found.results
    }
    drawn = [
        Figure(
            "explained",
            "Value less target, cause by cause, in percent of the tolerance; diamonds: the whole difference",
            stacked.draw(f"{found.case}-explained", bars, _causes(found.results), "Percent of the tolerance"),
        )
    ]
    for number, column in enumerate(found.columns, 1):
        if column.kind == "computed":
            bars = {
                one.key: {part.cause: _percent_of(one, part.value, False) for part in one.parts}
                for one in column.results
            }
            name = f"explained-{number}"
            caption = f"{column.name} less target, cause by cause, in percent of the target"
            picture = stacked.draw(
                f"{found.case}-{name}", bars, _causes(column.results), "Percent of the target"
            )
            drawn.append(Figure(name, caption, picture))
    return drawn


def summary(found: Explanation) -> str:
    """The largest part that nothing explains, as a share of its tolerance."""
    rest = [_share(one, one.unexplained.value) for one in found.results]
    return f"{share(max(rest, default=0.0) / 100.0)} of a tolerance unexplained"


def tables(found: Explanation) -> list[Table]:
    """A table for the results, and one for each published column."""
    return [_table(found.results, "value")] + [
        _table(column.results, column.name) for column in found.columns
    ]


def remarks(found: Explanation) -> list[str]:
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


def _column_text(column: Column, case: Case) -> list[str]:
    """What a published column seems to be."""
    count = f"{len(column.same)} of {len(column.results)} figures"
    if column.kind == "target":
        odd = [one.key for one in column.results if one.key not in column.same]
        rest = f" Not so: {', '.join(odd)}." if odd else ""
        return [f"{column.name}: {count} are the targets of this case, rounded.{rest}"]
    unit = case.file.units.time
    also = ", ".join(f"{interval:g} {unit}" for interval in column.also)
    text = f"{column.name}: of all readings tried, {column.reading}, gives most of it: {count}"
    text += f"; {also} gives as many." if also else "."
    others = [f"{key} fits {reading}." for key, reading in column.others.items()]
    return [" ".join([text, *others])]


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
