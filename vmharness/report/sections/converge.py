"""Section on convergence: each result on finer and finer levels."""

import msgspec

from vmharness.case import Case
from vmharness.report import number
from vmharness.report.blocks import Figure, Section, Table
from vmharness.studies.converge.record import ConvergeRecord, Refined
from vmharness.studies.converge.richardson import SAFETY, Kind

REFINED = {
    "time step": "the time step",
    "mesh": "the mesh",
    "both": "the mesh and, with it, the time step",
}
MEANINGS = {
    Kind.EXACT: "the value is the same on every level, except for round-off",
    Kind.OSCILLATES: "the differences between levels change sign, so that there is no order",
    Kind.DIVERGES: "the differences between levels do not decrease, so that there is no order",
    Kind.NOT_ASYMPTOTIC: "the order changes from three levels to the next three, so that no order is given",
    Kind.NO_VALUE: "a level gave no value",
}


def section(content: bytes, case: Case) -> Section:
    """The section for the record of `vm converge`."""
    found = msgspec.json.decode(content, type=ConvergeRecord)
    return Section(
        "Convergence",
        summary(found),
        text=_text(found),
        tables=tables(found),
        remarks=remarks(found),
    )


def figures(content: bytes) -> list[Figure]:
    """The error of each result over the size."""
    from vmharness.report.figures import refinement

    found = msgspec.json.decode(content, type=ConvergeRecord)
    caption = "Error of each result over the size; dashed lines: the expected order"
    return [Figure("convergence", caption, refinement.draw(found))]


def plan(found: ConvergeRecord) -> str:
    """What is refined, and what is held constant."""
    held = f" Held constant: {found.held}." if found.held else ""
    refined = f"{REFINED[found.refined]} is refined on {len(found.levels)} levels; its size is {found.size}."
    return refined[0].upper() + refined[1:] + held


def summary(found: ConvergeRecord) -> str:
    """The lowest and the highest order of the results with an expected order, or that one is too low."""
    promised = [result for result in found.results if result.promised is not None]
    orders = [result.found.order for result in promised if result.found.order is not None]
    if any(result.agrees is False for result in promised):
        return "an order is too low"
    if not orders:
        exact = all(result.found.kind is Kind.EXACT for result in found.results)
        return "exact" if exact else "no order"
    low, high = f"{min(orders):.1f}", f"{max(orders):.1f}"
    return f"order {low}" if low == high else f"order {low} to {high}"


def tables(found: ConvergeRecord) -> list[Table]:
    """The value of each result on each level; then its order and its extrapolated value."""
    levels = [f"N = {level.number:g}" for level in found.levels]
    values = [[result.key, *(_digits(value) for value in result.values)] for result in found.results]
    follows = ["Result", "Order", "Expected", "Extrapolated", "GCI", "Theory", "Within GCI"]
    return [Table(["Result", *levels], values), Table(follows, [_row(result) for result in found.results])]


def remarks(found: ConvergeRecord) -> list[str]:
    """The meaning of each word that stands in place of an order, and the levels that failed."""
    said = []
    for kind, meaning in MEANINGS.items():
        keys = [result.key for result in found.results if result.found.kind is kind]
        if keys:
            said.append(f"{kind} ({', '.join(keys)}): {meaning}.")
    return said + [f"N = {level.number:g}: {level.failure}." for level in found.levels if level.failure]


def _text(found: ConvergeRecord) -> list[str]:
    return [
        f"{plan(found)} Expected orders: {found.because}.",
        "The order follows from the three finest levels. Its uncertainty (±) is the largest difference from the order "
        "of any other three successive levels. The extrapolated value is Richardson's for a size of zero. GCI is "
        f"Roache's grid convergence index with a safety factor of {SAFETY:g}; theory should lie within ± GCI of the "
        "extrapolated value.",
    ]


def _row(result: Refined) -> list[str]:
    sequence = result.found
    return [
        result.key,
        _order(result),
        number.short(result.promised),
        _digits(sequence.extrapolated),
        number.DASH if sequence.gci is None else f"{sequence.gci:.1e}",
        _digits(result.target),
        {True: "yes", False: "no", None: number.DASH}[result.inside],
    ]


def _order(result: Refined) -> str:
    sequence = result.found
    if sequence.order is None:
        return str(sequence.kind)
    open_ = "" if sequence.uncertainty is None else f" ± {sequence.uncertainty:.2f}"
    return f"{sequence.order:.2f}{open_}"


def _digits(value: float | None) -> str:
    return number.DASH if value is None else f"{value:#.7g}".rstrip(".")
