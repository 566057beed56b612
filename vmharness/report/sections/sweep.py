"""Sweep: whether the formulas hold beyond one point of the given data."""

import msgspec

from vmharness.case import Case
from vmharness.report import number
from vmharness.report.blocks import Figure, Section, Table
from vmharness.round_off import ROUND_OFF
from vmharness.studies.sweep.record import SweepRecord, Worst, worst_share

WORST = "For each result, the point at which it uses most of its tolerance:"


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm sweep`."""
    found = msgspec.json.decode(content, type=SweepRecord)
    return Section(
        "Sweep over the given data",
        summary(found),
        text=[plan(found), f"{verdict(found)} {WORST}"],
        tables=tables(found),
        remarks=remarks(found),
    )


def figures(content: bytes) -> list[Figure]:
    """Shares of tolerances over each datum."""
    from vmharness.report.figures import scatter

    found = msgspec.json.decode(content, type=SweepRecord)
    caption = (
        "Largest share of a tolerance that a result uses at each point, over each datum; large: out of it"
    )
    return [Figure("sweep", caption, scatter.draw(found))]


def plan(found: SweepRecord) -> str:
    """Where the points lie."""
    ranges = [
        f"{name} from {number.given(low)} to {number.given(high)} {found.units[name]}".rstrip()
        for name, (low, high) in found.ranges.items()
    ]
    held = "".join(f" Held: {sentence}." for sentence in found.within)
    return f"{found.how}, over {'; '.join(ranges)}.{held}"


def verdict(found: SweepRecord) -> str:
    """At how many points all results are within their tolerances."""
    passed = found.points - len(found.failed) - len(found.unjudged)
    open_ = f"; {len(found.unjudged)} could not be judged" if found.unjudged else ""
    return f"Every result is within its tolerance at {passed} of {found.points} points{open_}."


def summary(found: SweepRecord) -> str:
    """How many points pass, and the largest share of a tolerance."""
    judged = [i for i in range(found.points) if i not in found.unjudged]
    passed = len(judged) - len(found.failed)
    worst = max((worst_share(found, i) for i in judged), default=None)
    return f"{passed} of {found.points} points, {number.share(worst)} used at most"


def tables(found: SweepRecord) -> list[Table]:
    """Each result where it uses most of its tolerance."""
    head = ["Result", "Failed", "Worst share", "Error (%)", *found.ranges]
    return [Table(head, [_row(found, result) for result in found.results])]


def remarks(found: SweepRecord) -> list[str]:
    """The failing point made simpler, and points that could not be judged."""
    said = []
    if found.failing is not None:
        said.append(f"Out of tolerance: {found.failing.why}. The simplest such point: {found.failing.again}")
    reasons: dict[str, int] = {}
    for reason in found.unjudged.values():
        reasons[reason] = reasons.get(reason, 0) + 1
    return said + [f"Not judged, {count} points: {reason}" for reason, count in reasons.items()]


def _row(found: SweepRecord, result: Worst) -> list[str]:
    at = [number.short(result.at.get(name)) for name in found.ranges]
    if result.error is not None and abs(result.error) <= ROUND_OFF:
        return [result.key, str(result.failed), "round-off", "0", *at]
    error = number.positional(None if result.error is None else 100.0 * result.error, 2)
    return [result.key, str(result.failed), number.share(result.share), error, *at]
