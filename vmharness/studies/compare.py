"""Comparison of two runs of the manual, result by result."""

import math
from dataclasses import dataclass

from vmharness.export import Case, Result, Run
from vmharness.round_off import ROUND_OFF, ordered

RANK = {"pass": 0, "fail": 1, "error": 2}


@dataclass(frozen=True)
class Pair:
    """A result of two runs; None is a missing value."""

    case: str
    key: str
    unit: str
    first: float | None
    second: float | None
    percent: float | None  # second - first, of the target (of the first value, where the target is zero)
    share: float | None  # of the tolerance of the first
    verdicts: tuple[str, str]  # "missing" where a run has no such result
    remark: str = ""

    @property
    def worse(self) -> bool:
        """Whether the second run lacks the result or has a worse verdict."""
        first, second = self.verdicts
        return RANK.get(second, 3) > RANK.get(first, 3)


def pairs(first: Run, second: Run) -> list[Pair]:
    """Every result of either run with that of the other; the largest share of a tolerance first."""
    cases = {_name(case): case for case in first.cases}, {_name(case): case for case in second.cases}
    found = []
    for name in dict.fromkeys([*cases[0], *cases[1]]):
        results = tuple({r.key: r for r in (c[name].results if name in c else [])} for c in cases)
        found += [
            _pair(name, key, results[0].get(key), results[1].get(key))
            for key in dict.fromkeys([*results[0], *results[1]])
        ]
        if not any(results):
            verdicts = tuple(c[name].verdict if name in c else "missing" for c in cases)
            found.append(Pair(name, "", "", None, None, None, None, (verdicts[0], verdicts[1])))
    return sorted(ordered(found, lambda pair: -(pair.share or 0.0)), key=lambda pair: not pair.worse)


def _name(case: Case) -> str:
    data = ",".join(f"{name}={value:g}" for name, value in case.set.items())
    return f"{case.id}@{data}" if data else case.id


def _pair(case: str, key: str, a: Result | None, b: Result | None) -> Pair:
    known = a or b
    assert known is not None
    values = (a.value if a else None, b.value if b else None)
    verdicts = (a.verdict if a else "missing", b.verdict if b else "missing")
    percent = share = None
    if values[0] is not None and values[1] is not None:
        scale = abs(known.target or values[0]) or math.nan
        percent = 100.0 * (values[1] - values[0]) / scale if values[1] != values[0] else 0.0
        share = abs(percent) / known.tolerance_percent if known.tolerance_percent else None
    moved = bool(a and b and not _same(a.target, b.target))
    return Pair(
        case, key, known.unit, *values, percent, share, verdicts, "the target is another" if moved else ""
    )


def _same(a: float | None, b: float | None) -> bool:
    """Whether two targets are one but for round-off."""
    return a == b if a is None or b is None else math.isclose(a, b, rel_tol=ROUND_OFF)
