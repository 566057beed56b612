"""Convergence: what each result does as the case is refined."""

import msgspec

from vmharness.case import Case
from vmharness.report import number
from vmharness.report.blocks import Figure, Section, Table
from vmharness.studies.converge.record import ConvergeRecord, Refined
from vmharness.studies.converge.richardson import SAFETY, Kind

REFINED = {
    "time step": "the time step",
    "mesh": "the mesh",
    "both": "the mesh, and the time step with it",
}
MEANINGS = {
    Kind.EXACT: "the same at every level, to round-off",
    Kind.OSCILLATES: "the differences change sign, so that there is no order",
    Kind.DIVERGES: "the differences do not fall, so that there is no order",
    Kind.NOT_ASYMPTOTIC: "the order differs from three levels to the next three, so that none is given",
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
    """Distance from theory over the size."""
    from vmharness.report.figures import refinement

    found = msgspec.json.decode(content, type=ConvergeRecord)
    caption = "Distance of the results from theory over the size; dashed: the promised order"
    return [Figure("convergence", caption, refinement.draw(found))]


def plan(found: ConvergeRecord) -> str:
    """What is refined, what is held."""
    held = f" Held: {found.held}." if found.held else ""
    return f"Refined: {REFINED[found.refined]}; its size, {found.size}, on {len(found.levels)} levels.{held}"


def summary(found: ConvergeRecord) -> str:
    """The lowest and highest order seen among the promised ones, and whether each is as promised."""
    promised = [result for result in found.results if result.promised is not None]
    orders = [result.found.order for result in promised if result.found.order is not None]
    if any(result.agrees is False for result in promised):
        return "not of the promised order"
    if not orders:
        exact = all(result.found.kind is Kind.EXACT for result in found.results)
        return "exact" if exact else "no order"
    low, high = f"{min(orders):.1f}", f"{max(orders):.1f}"
    return f"order {low}" if low == high else f"order {low} to {high}"


def tables(found: ConvergeRecord) -> list[Table]:
    """The value of each result at each level; then what follows from them."""
    levels = [f"N = {level.number:g}" for level in found.levels]
    values = [[result.key, *(_digits(value) for value in result.values)] for result in found.results]
    follows = ["Result", "Order", "Promised", "Extrapolated", "GCI", "Theory", "Inside"]
    return [Table(["Result", *levels], values), Table(follows, [_row(result) for result in found.results])]


def remarks(found: ConvergeRecord) -> list[str]:
    """What the words in place of an order mean, where they stand, and levels that failed."""
    said = []
    for kind, meaning in MEANINGS.items():
        keys = [result.key for result in found.results if result.found.kind is kind]
        if keys:
            said.append(f"{kind} ({', '.join(keys)}): {meaning}.")
    return said + [f"N = {level.number:g}: {level.failure}." for level in found.levels if level.failure]


def _text(found: ConvergeRecord) -> list[str]:
    return [
        f"{plan(found)} Promised orders: {found.because}.",
        "The order is that of the three finest levels, and its uncertainty the largest distance of the order of "
        "another three in a row. Extrapolated is Richardson's value for a size of zero; GCI is Roache's grid "
        f"convergence index, with a safety factor of {SAFETY:g}: theory should lie so near what is extrapolated.",
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
