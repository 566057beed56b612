"""Results as JSON; `schema` moves when the meaning of a key does."""

import json
import math
from typing import Any

from vmharness import __version__
from vmharness.result import CaseRun, Row

SCHEMA = 1


def render(runs: list[CaseRun]) -> str:
    """All runs; what is not there, not a number or infinite is null."""
    document = {"schema": SCHEMA, "version": __version__, "cases": [_case(run) for run in runs]}
    return json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _case(run: CaseRun) -> dict[str, Any]:
    return {
        "id": run.case.id,
        "title": run.case.file.title,
        "solver": run.solution.solver,
        "verdict": str(run.verdict),
        "seconds": _number(run.seconds),
        "cycles": run.solution.cycles,
        "results": [_result(row) for row in run.rows],
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
