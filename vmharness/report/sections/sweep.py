"""Section on the sweep: whether the results agree with theory over a region of the data."""

import msgspec

from vmharness.case import Case
from vmharness.report import number
from vmharness.report.blocks import Figure, Section, Table
from vmharness.round_off import ROUND_OFF
from vmharness.studies.sweep.record import SweepRecord, Worst, worst_share

WORST = "The table shows, for each result, the point where it uses the largest share of its tolerance:"


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
    caption = "Largest share of a tolerance at each point, over each datum; large marks: out of tolerance"
    return [Figure("sweep", caption, scatter.draw(found))]


def plan(found: SweepRecord) -> str:
    """The number, ranges and constraints of the points."""
    ranges = [
        f"{name} from {number.given(low)} to {number.given(high)} {found.units[name]}".rstrip()
        for name, (low, high) in found.ranges.items()
    ]
    constraints = "".join(f" Constraint: {sentence}." for sentence in found.within)
    return f"{found.how}. Ranges: {'; '.join(ranges)}.{constraints}"


def verdict(found: SweepRecord) -> str:
    """At how many points all results are within their tolerances."""
    passed = found.points - len(found.failed) - len(found.unjudged)
    open_ = f"; {len(found.unjudged)} could not be judged" if found.unjudged else ""
    return f"All results are within their tolerances at {passed} of {found.points} points{open_}."


def summary(found: SweepRecord) -> str:
    """How many points pass, and the largest share of a tolerance."""
    judged = [i for i in range(found.points) if i not in found.unjudged]
    passed = len(judged) - len(found.failed)
    worst = max((worst_share(found, i) for i in judged), default=None)
    return f"{passed} of {found.points} points pass, largest share {number.share(worst)}"


def tables(found: SweepRecord) -> list[Table]:
    """Each result at the point where it uses the largest share of its tolerance."""
    head = ["Result", "Points failed", "Largest share", "Error (%)", *found.ranges]
    return [Table(head, [_row(found, result) for result in found.results])]


def remarks(found: SweepRecord) -> list[str]:
    """The simplest failing point, and the points without a verdict."""
    said = []
    if found.failing is not None:
        said.append(
            f"Out of tolerance: {found.failing.why}. The simplest point that fails: {found.failing.again}"
        )
    reasons: dict[str, int] = {}
    for reason in found.unjudged.values():
        reasons[reason] = reasons.get(reason, 0) + 1
    return said + [f"{_points(count)} could not be judged: {reason}" for reason, count in reasons.items()]


def _points(count: int) -> str:
    return "1 point" if count == 1 else f"{count} points"


def _row(found: SweepRecord, result: Worst) -> list[str]:
    at = [number.short(result.at.get(name)) for name in found.ranges]
    if result.error is not None and abs(result.error) <= ROUND_OFF:
        return [result.key, str(result.failed), "round-off", "0", *at]
    error = number.positional(None if result.error is None else 100.0 * result.error, 2)
    return [result.key, str(result.failed), number.share(result.share), error, *at]
