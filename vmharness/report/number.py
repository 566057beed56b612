"""Numbers as the report prints them: a fixed number of digits, no negative zero, a dash for a missing value.

Round-off is taken off before: a number half-way between two of fewer digits prints alike on every machine.
"""

import math
import re
from decimal import Decimal

from vmharness.round_off import rounded

DASH = "–"


def significant(value: float | None) -> str:
    """Six significant digits, trailing zeros kept, as in a table.

    >>> significant(-1.0), significant(0.07198157), significant(3e7), significant(-0.0), significant(None)
    ('-1.00000', '0.0719816', '3.00000e7', '0', '–')
    """
    if value is None or not math.isfinite(value):
        return DASH
    return _tidy(f"{rounded(value):#.6g}").rstrip(".") if value else "0"


def short(value: float | None) -> str:
    """Up to six significant digits, without trailing zeros, as in a formula.

    >>> short(193.0), short(0.09777499), short(2.5e7), short(-0.0)
    ('193', '0.097775', '2.5e7', '0')
    """
    if value is None or not math.isfinite(value):
        return DASH
    return _tidy(f"{rounded(value):.6g}") if value else "0"


def given(value: float) -> str:
    """The fewest digits that give a datum exactly.

    >>> given(0.5), given(386.0), given(1973.8886), given(3.0e7), given(7.3e-4)
    ('0.5', '386', '1973.8886', '3e7', '0.00073')
    """
    digits = repr(float(value)).removesuffix(".0")
    if re.fullmatch(r"-?\d{6,}", digits) and digits.endswith("000"):
        mantissa = digits.lstrip("-").rstrip("0")
        point = f".{mantissa[1:]}" if len(mantissa) > 1 else ""
        digits = f"{'-' if value < 0 else ''}{mantissa[0]}{point}e{len(digits.lstrip('-')) - 1}"
    return _tidy(digits)


def decimals(value: float | None, places: int = 4) -> str:
    """A fixed number of decimals, as for percentages.

    >>> decimals(-0.4429), decimals(-1e-9), decimals(0.25, 2), decimals(None)
    ('-0.4429', '0.0000', '0.25', '–')
    """
    if value is None or not math.isfinite(value):
        return DASH
    text = f"{rounded(value):.{places}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def positional(value: float | None, digits: int = 3) -> str:
    """A few significant digits, without an exponent above 1e-6: for tolerances and budgets in percent.

    >>> positional(5e-5), positional(0.001), positional(0.0005493, 2), positional(-9.24e-10, 2), positional(None)
    ('0.00005', '0.001', '0.00055', '-9.2e-10', '–')
    """
    if value is None or not math.isfinite(value):
        return DASH
    value = rounded(value)
    if 0.0 < abs(value) < 1e-6:
        return _tidy(f"{value:.{digits}g}")
    return f"{Decimal(f'{value:.{digits}g}').normalize():f}"


def error(percent: float | None, tolerance: float | None) -> str:
    """An error in percent, to a hundredth of its tolerance; one far out of tolerance to four digits.

    >>> error(6.5e-6, 5e-5), error(-0.44294, 1.0), error(3.456789, 0.001), error(2e-12, 5e-11), error(1e-16, 0.1)
    ('0.0000065', '-0.44', '3.457', '2e-12', '0.000')
    """
    if percent is None or not tolerance or not math.isfinite(percent) or abs(percent) > 1e3 * tolerance:
        return positional(percent, 4)
    places = 2 - math.floor(math.log10(rounded(tolerance)))
    return decimals(percent, max(places, 0)) if places < 10 else positional(percent, 2)


def fraction(value: float | None, target: float, unit: str) -> str:
    """A number of an error budget: in percent of the target, or in its unit if the target is zero.

    >>> fraction(5.5e-6, 2.0, "m"), fraction(5e-7, 0.0, "m"), fraction(None, 2.0, "m")
    ('0.00055', '5e-7 m', '–')
    """
    if target == 0.0 and value is not None:
        return f"{short(value)} {unit}".rstrip()
    return positional(None if value is None else 100.0 * value, 2)


def share(value: float | None) -> str:
    """A share of a tolerance in whole percent, or as a multiple if it is large.

    >>> share(0.3391), share(0.0004), share(1.25), share(283.2), share(None)
    ('34 %', '<1 %', '125 %', '283 ×', '–')
    """
    if value is None or not math.isfinite(value):
        return DASH
    value = rounded(value)
    if value < 0.005:
        return "<1 %"
    return f"{rounded(100.0 * value):.0f} %" if value < 10.0 else f"{value:.0f} ×"


def _tidy(text: str) -> str:
    """1e+07 as 1e7."""
    return re.sub(r"e([-+])0*(\d+)$", lambda found: f"e{found[1].strip('+')}{found[2]}", text)
