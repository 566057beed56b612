"""Record of the last run: status and errors of each case."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from vmharness.suite.outcome import Outcome, Status

FILE = ".last-run.json"


def read(folder: Path) -> dict[str, str]:
    """Status by id; empty if there is no readable record."""
    return {id: str(entry["status"]) for id, entry in _entries(folder).items()}


def errors(folder: Path) -> dict[str, dict[str, float]]:
    """Errors (value - target)/target by id, then by key, for results with a value and a target that is not zero."""
    return {id: entry["errors"] for id, entry in _entries(folder).items()}


def not_passed(folder: Path) -> set[str]:
    """Ids of the cases that did not pass, or were not reached, in the last run."""
    return {id for id, status in read(folder).items() if status != Status.PASS}


def write(folder: Path, outcomes: Iterable[Outcome]) -> None:
    """Write the new outcomes; those of other cases stay, and errors of a case that is not run."""
    from vmharness.execution import atomic

    known = _entries(folder)
    for outcome in outcomes:
        errors = _errors(outcome) or known.get(outcome.id, {"errors": {}})["errors"]
        known[outcome.id] = {"status": str(outcome.status), "errors": errors}
    atomic.write(folder / FILE, json.dumps(dict(sorted(known.items())), indent=1) + "\n")


def _entries(folder: Path) -> dict[str, dict[str, Any]]:
    """Status and errors by id, as far as the file is a record."""
    try:
        found = json.loads((folder / FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    entries = found.items() if isinstance(found, dict) else ()
    return {
        id: {"status": entry["status"], "errors": _numbers(entry.get("errors"))}
        for id, entry in entries
        if isinstance(entry, dict) and "status" in entry
    }


def _numbers(errors: object) -> dict[str, float]:
    if not isinstance(errors, dict):
        return {}
    return {key: error for key, error in errors.items() if isinstance(error, float | int)}


def _errors(outcome: Outcome) -> dict[str, float]:
    if outcome.run is None:
        return {}
    percents = {row.key: row.comparison.error_percent for row in outcome.run.rows}
    return {key: percent / 100.0 for key, percent in percents.items() if percent is not None}
