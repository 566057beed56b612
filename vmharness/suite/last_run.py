"""What became of each case when it was last run, so that only those that did not pass can be run again."""

import json
from collections.abc import Iterable
from pathlib import Path

from vmharness.suite.outcome import Outcome, Status

FILE = ".last-run.json"


def read(folder: Path) -> dict[str, str]:
    """Status by id; nothing where there is no such file, or one that cannot be read."""
    try:
        found = json.loads((folder / FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def not_passed(folder: Path) -> set[str]:
    """Ids of the cases that did not pass when last run, or were not reached."""
    return {id for id, status in read(folder).items() if status != Status.PASS}


def write(folder: Path, outcomes: Iterable[Outcome]) -> None:
    """Keep the new outcomes; those of cases that were not selected stay."""
    from vmharness.report import atomic

    known = {**read(folder), **{outcome.id: str(outcome.status) for outcome in outcomes}}
    atomic.write(folder / FILE, json.dumps(dict(sorted(known.items())), indent=1) + "\n")
