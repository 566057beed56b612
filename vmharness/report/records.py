"""Records of studies beside the page of a case: written, made into sections of the page, and checked for age."""

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
from vmharness.report.blocks import Section
from vmharness.round_off import rounded
from vmharness.studies.maker import Maker

OLD = "The case was changed after this study, which describes the earlier case."
STUDIES = "vmharness.report.sections"
FOLDER = "studies"
DIGITS = 10  # of a number in a record
HASH = 8  # digits of a hash that are shown


@dataclass(frozen=True)
class Stamp:
    """The entries that the record of every study has."""

    case_sha256: str | None = None  # of the inputs of the case
    made_by: Maker | None = None

    @property
    def says(self) -> str:
        """The solver and the sources that made the record, as a sentence.

        >>> Stamp(made_by=Maker("vmharness 0.1.0", "3f2a9c1d" + 56 * "0")).says
        'Made by vmharness 0.1.0, sources 3f2a9c1d.'
        """
        if self.made_by is None:
            return "The record does not name the solver and the sources that made it."
        return f"Made by {self.made_by.solver or 'no solver'}, sources {self.made_by.sources[:HASH]}."


@dataclass(frozen=True)
class Studies:
    """The studies on a page: their own sections, and their findings on published columns by name."""

    sections: Sequence[Section] = ()
    columns: Mapping[str, Section] = field(default_factory=dict)


def write(root: Path, case: str, name: str, record: Any) -> Path:
    """Write the record of a study (a dataclass) beside the page of a case; equal records give equal bytes.

    Numbers are rounded to DIGITS digits, because further digits differ from machine to machine.
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
    """The sections of all studies with a record in `folder`, beside the page; none if the data are not the case's.

    A record of another version, or one that is damaged, is left out: `vm check` names it.
    """
    found: list[Section] = []
    columns: dict[str, Section] = {}
    for study, content in _records(case, folder):
        with contextlib.suppress(Exception):  # whatever a file raises that is no such record
            section: Section = study.section(content, case)
            if hasattr(study, "figures"):
                section = replace(section, figures=[*section.figures, *study.figures(content)])
            section = _stamped(section, content, case)
            told = study.columns(content, case) if hasattr(study, "columns") else {}
            columns |= {name: _stamped(about, content, case) for name, about in told.items()}
            found.append(section)
    return Studies(found, columns)


def summaries(case: Case, folder: Path) -> list[str]:
    """The finding of each study in a few words, without drawings."""
    found = []
    for study, content in _records(case, folder):
        with contextlib.suppress(Exception):  # as above
            found.append(study.section(content, case).summary)
    return found


def _records(case: Case, folder: Path) -> Iterator[tuple[ModuleType, bytes]]:
    """The record of each study that has one, with the module that makes a section of it."""
    for name in [] if case.changed else plugins.names(STUDIES):
        path = folder / FOLDER / f"{name}.json"
        if path.is_file():
            yield plugins.module(STUDIES, name), path.read_bytes()


def _stamped(section: Section, content: bytes, case: Case) -> Section:
    """The section with the maker of its record, and a warning if the case or its deck has changed since."""
    stamp = msgspec.json.decode(content, type=Stamp)
    if stamp.case_sha256 not in (None, case.inputs_sha256):
        section = replace(section, text=[OLD, *section.text])
    return replace(section, made=stamp.says)


def stale(studies: Path, case_sha256: str, sources: str) -> list[str]:
    """Sentences on the records in a folder that other sources or another state of the case made.

    `case_sha256` is the hash of the inputs of the case, `sources` that of the solver.
    """
    found: dict[str, list[str]] = {}
    for path in sorted(studies.glob("*.json")):
        for reason in _reasons(path, case_sha256, sources):
            found.setdefault(reason, []).append(path.stem)
    return [f"study {', '.join(names)}: {reason}" for reason, names in found.items()]


def _reasons(path: Path, case_sha256: str, sources: str) -> list[str]:
    try:
        stamp = msgspec.json.decode(path.read_bytes(), type=Stamp)
    except (OSError, RecursionError, msgspec.MsgspecError):
        return ["the record cannot be read"]
    reasons = [] if stamp.case_sha256 == case_sha256 else ["the case was changed after the study"]
    if stamp.made_by is None:
        reasons.append("the record does not name the sources that made it")
    elif stamp.made_by.sources != sources:
        made, now = stamp.made_by.sources[:HASH], sources[:HASH]
        reasons.append(f"made from sources {made}; the sources are now {now}")
    return reasons
