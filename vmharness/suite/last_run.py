"""What became of each case when it was last run: what to run again, and how far it was from theory."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from vmharness.suite.outcome import Outcome, Status

FILE = ".last-run.json"


def read(folder: Path) -> dict[str, str]:
    """Status by id; nothing where there is no such file, or one that cannot be read."""
    return {id: str(entry["status"]) for id, entry in _entries(folder).items()}


def errors(folder: Path) -> dict[str, dict[str, float]]:
    """By id, then by key: (value - target)/target of the results that had a value, and a target that is not zero."""
    return {id: entry.get("errors", {}) for id, entry in _entries(folder).items()}


def not_passed(folder: Path) -> set[str]:
    """Ids of the cases that did not pass when last run, or were not reached."""
    return {id for id, status in read(folder).items() if status != Status.PASS}


def write(folder: Path, outcomes: Iterable[Outcome]) -> None:
    """Keep the new outcomes; those of cases that were not selected stay."""
    from vmharness.execution import atomic

    new = {outcome.id: {"status": str(outcome.status), "errors": _errors(outcome)} for outcome in outcomes}
    known = {**_entries(folder), **new}
    atomic.write(folder / FILE, json.dumps(dict(sorted(known.items())), indent=1) + "\n")


def _entries(folder: Path) -> dict[str, dict[str, Any]]:
    try:
        found = json.loads((folder / FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    if not isinstance(found, dict):
        return {}
    return {id: entry for id, entry in found.items() if isinstance(entry, dict) and "status" in entry}


def _errors(outcome: Outcome) -> dict[str, float]:
    if outcome.run is None:
        return {}
    percents = {row.key: row.comparison.error_percent for row in outcome.run.rows}
    return {key: percent / 100.0 for key, percent in percents.items() if percent is not None}
