"""What a study leaves beside a case's page, and how the page shows it."""

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import Any

import msgspec

from vmharness import dropins
from vmharness.case import Case
from vmharness.report import atomic
from vmharness.report.stamp import Stamp

OLD = "The case was changed after this study: it is of an earlier state."
STUDIES = "vmharness.report.studies"
FOLDER = "studies"


@dataclass(frozen=True)
class Figure:
    """A drawing: the stem of its file, its caption, its <svg> element."""

    name: str
    caption: str
    svg: str


@dataclass(frozen=True)
class Table:
    """Rows of text under a head; columns from `numbers` on are numbers."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: int = 1


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


def write(root: Path, case: str, name: str, record: Any) -> Path:
    """Leave the record of a study (a dataclass) for the page of a case; the same record makes the same bytes."""
    content = msgspec.json.format(msgspec.json.encode(record), indent=1)
    return atomic.write(root / case / FOLDER / f"{name}.json", content.decode() + "\n")


def sections(case: Case, folder: Path, drawn: bool = True) -> list[Section]:
    """What the studies left in `folder`, where the page of the case lies; nothing for other data than the case's.

    A record that cannot be read, because it is of another version, is left out; drawings are unless `drawn`.
    """
    found = []
    for name in [] if case.changed else dropins.names(STUDIES):
        path = folder / FOLDER / f"{name}.json"
        if path.is_file():
            with contextlib.suppress(msgspec.MsgspecError):
                found.append(_section(dropins.module(STUDIES, name), path.read_bytes(), case, drawn))
    return found


def _section(study: ModuleType, content: bytes, case: Case, drawn: bool) -> Section:
    section: Section = study.section(content, case)
    if drawn and hasattr(study, "figures"):
        section = replace(section, figures=[*section.figures, *study.figures(content)])
    stamp = msgspec.json.decode(content, type=Stamp)
    if stamp.case_sha256 not in (None, case.inputs_sha256):
        section = replace(section, text=[OLD, *section.text])
    return replace(section, made=stamp.says)
