"""What a study leaves beside a case's page, and how the page shows it."""

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import ModuleType
from typing import Any

import msgspec

from vmharness import plugins
from vmharness.case import Case
from vmharness.execution import atomic
from vmharness.report.stamp import Stamp
from vmharness.round_off import rounded

OLD = "The case was changed after this study: it is of an earlier state."
STUDIES = "vmharness.report.sections"
FOLDER = "studies"
DIGITS = 10  # of a number in a record


@dataclass(frozen=True)
class Figure:
    """A drawing: the stem of its file, its caption, its <svg> element."""

    name: str
    caption: str
    svg: str


@dataclass(frozen=True)
class Table:
    """Rows of text under a head; columns from `numbers` on are numbers, but for the last `words`."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: int = 1
    words: int = 0

    def is_number(self, column: int) -> bool:
        """Whether a column is of numbers."""
        return self.numbers <= column < len(self.head) - self.words


@dataclass(frozen=True)
class Section:
    """A section of the page: paragraphs, then tables, then figures, then remarks."""

    title: str
    summary: str  # a few words for the index, such as "order 2.00"
    text: Sequence[str] = ()
    tables: Sequence[Table] = ()
    figures: Sequence[Figure] = ()
    remarks: Sequence[str] = ()
    made: str = ""  # what made the record that all this is from


@dataclass(frozen=True)
class Studies:
    """All that studies say on a page: sections of their own, and what they found of published columns, by name."""

    sections: Sequence[Section] = ()
    columns: Mapping[str, Section] = field(default_factory=dict)


def write(root: Path, case: str, name: str, record: Any) -> Path:
    """Leave the record of a study (a dataclass) for the page of a case; the same record makes the same bytes.

    Its numbers are written to so many DIGITS: those behind differ from machine to machine.
    """
    content = msgspec.json.format(msgspec.json.encode(_stable(msgspec.to_builtins(record))), indent=1)
    return atomic.write(root / case / FOLDER / f"{name}.json", content.decode() + "\n")


def _stable(content: Any) -> Any:
    """The content of a record with its numbers rounded."""
    match content:
        case float():
            return rounded(content, DIGITS)
        case dict():
            return {name: _stable(value) for name, value in content.items()}
        case list() | tuple():
            return [_stable(value) for value in content]
    return content


def studies(case: Case, folder: Path) -> Studies:
    """What the studies left in `folder`, where the page of the case lies; nothing for other data than the case's.

    A record that cannot be read, because it is of another version, is left out.
    """
    found: list[Section] = []
    columns: dict[str, Section] = {}
    for study, content in _records(case, folder):
        with contextlib.suppress(msgspec.MsgspecError):
            section: Section = study.section(content, case)
            if hasattr(study, "figures"):
                section = replace(section, figures=[*section.figures, *study.figures(content)])
            found.append(_stamped(section, content, case))
            if hasattr(study, "columns"):
                told = study.columns(content, case)
                columns |= {name: _stamped(about, content, case) for name, about in told.items()}
    return Studies(found, columns)


def summaries(case: Case, folder: Path) -> list[str]:
    """What each study found, in a few words; nothing is drawn."""
    found = []
    for study, content in _records(case, folder):
        with contextlib.suppress(msgspec.MsgspecError):
            found.append(study.section(content, case).summary)
    return found


def _records(case: Case, folder: Path) -> Iterator[tuple[ModuleType, bytes]]:
    """The record of each study that left one, with the module that knows it."""
    for name in [] if case.changed else plugins.names(STUDIES):
        path = folder / FOLDER / f"{name}.json"
        if path.is_file():
            yield plugins.module(STUDIES, name), path.read_bytes()


def _stamped(section: Section, content: bytes, case: Case) -> Section:
    """With what made the record, and whether the case or its deck has changed since."""
    stamp = msgspec.json.decode(content, type=Stamp)
    if stamp.case_sha256 not in (None, case.inputs_sha256):
        section = replace(section, text=[OLD, *section.text])
    return replace(section, made=stamp.says)
