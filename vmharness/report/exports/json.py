"""Results as JSON; the number `schema` changes with the meaning of a key."""

import json
import math
from collections.abc import Sequence
from typing import Any

from vmharness import __version__
from vmharness.compare import Verdict
from vmharness.result import CaseRun, Row, Unrun

SCHEMA = 1


def render(runs: Sequence[CaseRun], unrun: Sequence[Unrun]) -> str:
    """All runs, then the cases without a run; missing values, NaN and infinity are null."""
    cases = [*map(_case, runs), *map(_unrun, unrun)]
    document = {"schema": SCHEMA, "version": __version__, "cases": cases}
    return json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _case(run: CaseRun) -> dict[str, Any]:
    """A run; `set` has the data that differ from those of the case, each in its unit."""
    case = run.case
    changed = {name: case.datum(name) for name in case.file.given if name in case.changed}
    return {
        "id": case.id,
        "title": case.file.title,
        "solver": run.solution.solver,
        "verdict": str(run.verdict),
        "seconds": _number(run.seconds),
        "cycles": run.solution.cycles,
        "results": [_result(row) for row in run.rows],
        **({"set": changed} if changed else {}),
    }


def _unrun(case: Unrun) -> dict[str, Any]:
    """A case without a run is an error, with a reason in place of results."""
    return {
        "id": case.id,
        "title": "",
        "solver": None,
        "verdict": str(Verdict.ERROR),
        "seconds": None,
        "cycles": None,
        "results": [],
        "reason": case.reason,
    }


def _result(row: Row) -> dict[str, Any]:
    comparison = row.comparison
    return {
        "key": row.key,
        "label": row.label,
        "event": row.event,
        "unit": row.unit,
        "target": _number(comparison.target),
        "value": _number(comparison.value),
        "error_percent": _number(comparison.error_percent),
        "tolerance_percent": _number(comparison.tolerance_percent),
        "verdict": str(row.verdict),
        "published": {name: float(published.text) for name, published in row.published.items()},
    }


def _number(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None
