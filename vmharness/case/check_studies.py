"""Checks of [converge] and [sweep] in case.toml; their formulas are kept."""

from itertools import pairwise

from vmharness.case.check import Checks
from vmharness.case.format import CaseFile
from vmharness.formula import DIMENSIONLESS

LEVEL = {"N": DIMENSIONLESS}  # further name in the formulas of a level


def check_converge(checks: Checks) -> None:
    """Levels increase, and each formula sets a datum in its unit."""
    plan = checks.file.converge
    if plan is None:
        return
    if "N" in checks.dimensions:
        raise checks.wrong("[converge]", "N is the name of the level; rename the datum or the line of theory")
    if any(fine <= coarse for coarse, fine in pairwise(plan.levels)):
        raise checks.wrong("[converge] levels", "must increase")
    checks.formula("[converge] size", "converge size", plan.size, LEVEL)
    for name, text in plan.set.items():
        place = f"[converge] set: {name}"
        checks.known(place, name, checks.file.given, "given datum")
        dimension = checks.formula(place, f"converge {name}", text, LEVEL)
        checks.unit(place, checks.file.given[name].unit, dimension)
    for key in plan.orders:
        checks.known("[converge] orders", key, checks.keys, "result")


def check_sweep(checks: Checks) -> None:
    """Ranges belong to data, and each formula sets another datum in its unit."""
    plan = checks.file.sweep
    if plan is None:
        return
    for name, (low, high) in plan.ranges.items():
        checks.known("[sweep] ranges", name, checks.file.given, "given datum")
        if not low < high:
            raise checks.wrong(f"[sweep] ranges: {name}", "the first value must be below the second")
    for number, constraint in enumerate(plan.within, 1):
        place = f"[sweep] within: {number}"
        if not constraint.low <= constraint.high:
            raise checks.wrong(place, "low must not be above high")
        checks.unit(place, "", checks.formula(place, f"within {number}", constraint.formula))
    for name, text in plan.set.items():
        place = f"[sweep] set: {name}"
        checks.known(place, name, checks.file.given, "given datum")
        if name in plan.ranges:
            raise checks.wrong(place, "is in ranges, so it cannot be set")
        checks.unit(place, checks.file.given[name].unit, checks.formula(place, f"sweep {name}", text))


def planned(file: CaseFile) -> list[tuple[str, str]]:
    """The data that studies set, with their places in the file."""
    found = [("[converge] set", name) for name in (file.converge.set if file.converge else ())]
    if file.sweep:
        found += [("[sweep] ranges", name) for name in file.sweep.ranges]
        found += [("[sweep] set", name) for name in file.sweep.set]
    return found
