"""Changes of a datum, as faults and studies write them."""

import re

from vmharness.case.error import CaseError

CHANGE = r"(?P<sign>[-+])\s*(?P<percent>\d+\.?\d*)\s*%|=\s*(?P<value>[-+]?\d+\.?\d*([eE][-+]?\d+)?)"
HOW = 'write "+1 %", "-0.1 %" or "=2.0"'


def changed_value(value: float, change: str, unit: float) -> float:
    """`value` after a change such as "+1 %" or "=2.0", the latter in a unit of the size `unit`.

    >>> changed_value(200.0, "-0.5 %", 10.0), changed_value(200.0, "=2.0", 10.0)
    (199.0, 20.0)
    """
    parts = re.fullmatch(CHANGE, change)
    if parts is None:
        raise CaseError(f'change "{change}": {HOW}')
    if parts["value"] is not None:
        return float(parts["value"]) * unit
    return value * (1.0 + float(parts["sign"] + parts["percent"]) / 100.0)
