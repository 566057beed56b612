"""Results as JSON; `schema` moves when the meaning of a key does."""

import json
import math
from collections.abc import Sequence
from typing import Any

from vmharness import __version__
from vmharness.compare import Verdict
from vmharness.result import CaseRun, Row, Unrun

SCHEMA = 1


def render(runs: Sequence[CaseRun], unrun: Sequence[Unrun]) -> str:
    """All runs, then the cases without one; what is not there, not a number or infinite is null."""
    cases = [*map(_case, runs), *map(_unrun, unrun)]
    document = {"schema": SCHEMA, "version": __version__, "cases": cases}
    return json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _case(run: CaseRun) -> dict[str, Any]:
    """A run; `set` holds the data that are not the case's own, each in its unit, if there are any."""
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
    """Missing is a failure: the case is there, with the reason in place of results."""
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
