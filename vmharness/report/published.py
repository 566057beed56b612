"""Published columns: the error of each and its source, in one section a column.

The reading that the case declares is applied to the history of every run; the findings of `vm explain` follow.
"""

from collections.abc import Mapping
from dataclasses import replace

from vmharness.case.format import Published
from vmharness.report import number
from vmharness.report.blocks import Section, Table
from vmharness.report.figures.characters import unit
from vmharness.report.figures.curves import time_factor, time_unit
from vmharness.result import CaseRun, Reading


def sections(run: CaseRun, explained: Mapping[str, Section]) -> dict[str, Section]:
    """A section for each column with a declared reading or with findings in `explained`, by name of the column."""
    return {
        column.name: _section(run, column, explained.get(column.name, Section("", "")))
        for column in run.case.published
        if run.readings.get(column.name) or column.name in explained
    }


def _section(run: CaseRun, column: Published, explained: Section) -> Section:
    read = run.readings.get(column.name, ())
    return replace(
        explained,
        title=f"Source of the published difference: {column.name}",
        text=[*([_read(run, column, read)] if read else []), *explained.text, *filter(None, [column.remark])],
        tables=[*([_table(run, column, read)] if read else []), *explained.tables],
    )


def _read(run: CaseRun, column: Published, read: tuple[Reading, ...]) -> str:
    """The reading that the case declares for a column, and how many figures it gives."""
    same = [reading for reading in read if reading.same]
    other = [reading for reading in read if not reading.same and reading.other_same]
    rest = [_name(run, reading) for reading in read if not (reading.same or reading.other_same)]
    sentences = [
        f"The {column.name} column agrees with values that are read from states {_time(run, column.interval)} "
        "apart. Each state is the last cycle up to its nominal time. An onset is the first state with contact, and an "
        "extremum is the state with the largest or smallest value; nothing is interpolated.",
        f"Read in this way, this run gives {_count(same, read)} figures of the {column.name} column.",
    ]
    if same:
        sentences.append(
            "The distance of these figures from theory comes from the reading, not from a solver."
        )
    sentences += [
        f"{_name(run, reading)} agrees with the value of this run at exactly {_time(run, reading.other[0])}."
        for reading in other
        if reading.other
    ]
    if rest:
        sentences.append(f"No reading of this run gives: {', '.join(rest)}.")
    return " ".join(sentences)


def _count(some: list[Reading], every: tuple[Reading, ...]) -> str:
    return f"all {len(every)}" if len(some) == len(every) else f"{len(some)} of the {len(every)}"


def _table(run: CaseRun, column: Published, read: tuple[Reading, ...]) -> Table:
    """Each figure beside the value of this run, read in the same way."""
    head = [
        "Result",
        "Target",
        column.name,
        "Error (%)",
        "This run",
        f"Time of the state ({time_unit(run.case)})",
    ]
    return Table([*head, "Same digits?"], [_row(run, reading) for reading in read], words=1)


def _row(run: CaseRun, reading: Reading) -> list[str]:
    error = 100.0 * (float(reading.published) / reading.target - 1.0) if reading.target else None
    same = _yes(reading.same)
    if reading.other:
        at, value = reading.other
        same += f"; at exactly {_time(run, at)}: {number.significant(value)}, {_yes(reading.other_same)}"
    return [
        f"{_name(run, reading)} ({unit(reading.unit)})" if reading.unit else _name(run, reading),
        number.significant(reading.target),
        reading.published,
        number.positional(error, 2),
        number.significant(reading.read),
        number.significant(reading.at / time_factor(run.case)),
        same,
    ]


def _time(run: CaseRun, time: float | None) -> str:
    """A time in the unit of the results that are times."""
    return f"{number.short(None if time is None else time / time_factor(run.case))} {time_unit(run.case)}"


def _yes(same: bool) -> str:
    return "✓ yes" if same else "✗ no"


def _name(run: CaseRun, reading: Reading) -> str:
    """What was read, and when."""
    return f"{reading.label} {run.case.file.events[run.case.result(reading.key).event].title.lower()}"
