"""Published columns: how far each is from theory, and where that comes from, in one section a column.

What the case declares of a column is tried on the history of every run; what `vm explain` found follows.
"""

from collections.abc import Mapping
from dataclasses import replace

from vmharness.case.format import Published
from vmharness.report import number
from vmharness.report.blocks import Section, Table
from vmharness.report.figures.characters import unit
from vmharness.result import CaseRun, Reading


def sections(run: CaseRun, explained: Mapping[str, Section]) -> dict[str, Section]:
    """A section for each column that this run is read as, or that is `explained`, by name of the column."""
    return {
        column.name: _section(run, column, explained.get(column.name, Section("", "")))
        for column in run.case.published
        if run.readings.get(column.name) or column.name in explained
    }


def _section(run: CaseRun, column: Published, explained: Section) -> Section:
    read = run.readings.get(column.name, ())
    return replace(
        explained,
        title=f"Where the published difference comes from: {column.name}",
        text=[*([_read(run, column, read)] if read else []), *explained.text, *filter(None, [column.remark])],
        tables=[*([_table(run, column, read)] if read else []), *explained.tables],
    )


def _read(run: CaseRun, column: Published, read: tuple[Reading, ...]) -> str:
    """How the column seems to have been read, and how much of it that accounts for."""
    rest = [_name(run, reading) for reading in read if not reading.same]
    time = run.case.file.units.time
    text = (
        f"The {column.name} column reads as if it were taken from states {number.short(column.interval)} {time} "
        "apart, each the last cycle not after its nominal time: for an onset the first state with contact, for an "
        "extremum the outermost state, without interpolation. "
    )
    if not rest:
        return text + f"Read this way, this run prints all {len(read)} figures of the {column.name} column."
    return text + (
        f"Read this way, this run prints {len(read) - len(rest)} of the {len(read)} figures of the {column.name} "
        "column; their distance from theory comes from the reading, not from a solver. "
        f"Not explained by it: {', '.join(rest)}."
    )


def _table(run: CaseRun, column: Published, read: tuple[Reading, ...]) -> Table:
    """Each figure beside the history of this run, read the same way."""
    time = run.case.file.units.time
    head = ["Result", "Target", column.name, "Its error (%)", "This run, so read", f"At time ({time})"]
    return Table([*head, "Same figures?"], [_row(run, reading) for reading in read], words=1)


def _row(run: CaseRun, reading: Reading) -> list[str]:
    error = 100.0 * (float(reading.published) / reading.target - 1.0) if reading.target else None
    same = _yes(reading.same)
    if reading.other:
        at, value = reading.other
        same += f"; at {number.short(at)} it is {number.significant(value)}: {_yes(reading.other_same)}"
    return [
        f"{_name(run, reading)} ({unit(reading.unit)})" if reading.unit else _name(run, reading),
        number.significant(reading.target),
        reading.published,
        number.decimals(error, 3),
        number.significant(reading.read),
        number.significant(reading.at),
        same,
    ]


def _yes(same: bool) -> str:
    return "✓ yes" if same else "✗ no"


def _name(run: CaseRun, reading: Reading) -> str:
    """What was read, and when."""
    return f"{reading.label} {run.case.file.events[run.case.result(reading.key).event].title.lower()}"
