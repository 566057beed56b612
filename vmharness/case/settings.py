"""Data of a case set to other values (`m=0.4`) or changed by a fault (`+1 %`)."""

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from vmharness.case.error import CaseError, near

if TYPE_CHECKING:
    from vmharness.case import Case

CHANGE = r"(?P<sign>[-+])\s*(?P<percent>\d+\.?\d*)\s*%|=\s*(?P<value>[-+]?\d+\.?\d*([eE][-+]?\d+)?)"
HOW = 'write "+1 %", "-0.1 %" or "=2.0"'


class SettingError(ValueError):
    """A setting that is not NAME=NUMBER."""


class RegionError(CaseError):
    """Data for which the theory of a case has no value, or its events do not happen."""


def parse(settings: Iterable[str]) -> dict[str, float]:
    """Names and numbers; raises SettingError.

    >>> parse(["m=0.4", "k = 2e3"])
    {'m': 0.4, 'k': 2000.0}
    """
    values: dict[str, float] = {}
    for setting in settings:
        name, _, number = setting.partition("=")
        try:
            value = float(number)
        except ValueError:
            value = float("nan")
        if not name.strip() or not abs(value) < float("inf"):
            raise SettingError(f"--set {setting}: write NAME=NUMBER, with the number in the unit of the case")
        if name.strip() in values:
            raise SettingError(f"--set {setting}: {name.strip()} is set twice")
        values[name.strip()] = value
    return values


def with_settings(case: "Case", settings: Mapping[str, float]) -> "Case":
    """The case with other data, each in its unit of the case; all formulas are evaluated.

    Raises CaseError for unknown data, and RegionError for data without a value of theory, a target or a parameter.
    """
    for name in settings:
        if name not in case.given:
            raise CaseError(f"{case.id}: no given datum {name}{near(name, case.given)}")
    factor = {name: case.units.factor(case.file.given[name].unit) for name in settings}
    for name in settings:
        case.check_can_be_set(name)
    try:
        changed = case.with_given({name: value * factor[name] for name, value in settings.items()})
        for name in changed.formulas:
            if not name.startswith(("curve ", "converge ")):  # these need a time or a level
                changed.evaluate(name)
    except CaseError as error:
        raise RegionError(str(error)) from None
    return changed


def as_options(settings: Mapping[str, float]) -> str:
    """The options of the command line that set these data.

    >>> as_options({"k": 2000.0, "m": 0.4})
    '--set k=2000 --set m=0.4'
    """
    return " ".join(f"--set {_assigned(name, value)}" for name, value in settings.items())


def _assigned(name: str, value: float) -> str:
    return f"{name}={value!r}".removesuffix(".0")


def label(id: str, settings: Mapping[str, float]) -> str:
    """The name of a case with other data, also of its folder.

    >>> label("VM-061", {"k": 2000.0, "m": 0.4})
    'VM-061@k=2000,m=0.4'
    """
    return f"{id}@{','.join(_assigned(name, value) for name, value in settings.items())}"


def changed_value(value: float, change: str, unit: float) -> float:
    """`value` after a change such as "+1 %" or "=2.0"; the latter is in a unit of the size `unit`.

    >>> changed_value(200.0, "-0.5 %", 10.0), changed_value(200.0, "=2.0", 10.0)
    (199.0, 20.0)
    """
    parts = re.fullmatch(CHANGE, change)
    if parts is None:
        raise CaseError(f'change "{change}": {HOW}')
    if parts["value"] is not None:
        return float(parts["value"]) * unit
    return value * (1.0 + float(parts["sign"] + parts["percent"]) / 100.0)
