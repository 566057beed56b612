"""Typeset unit: upright letters, raised exponents, dots between factors, one slash."""

from fractions import Fraction
from typing import TypeAlias

from vmharness.formula.notation import Notation

Powers: TypeAlias = tuple[tuple[str, Fraction], ...]


def unit_in(above: Powers, below: Powers, to: Notation) -> str:
    """The unit in a notation, "" if it is dimensionless; s^-1 has no slash, for 100 1/s would look like 1001/s."""
    if not (above and below):
        return _product((*above, *((symbol, -exponent) for symbol, exponent in below)), to)
    under = _product(below, to)
    return to.row(_product(above, to), to.sign("/"), to.fenced(under) if len(below) > 1 else under)


def _product(powers: Powers, to: Notation) -> str:
    factors = [_power(symbol, exponent, to) for symbol, exponent in powers]
    return to.row(*[part for factor in factors for part in (to.sign("·"), factor)][1:]) if factors else ""


def _power(symbol: str, exponent: Fraction, to: Notation) -> str:
    letters = to.upright(symbol)
    if exponent == 1:
        return letters
    size = to.number(str(abs(exponent)))
    return to.power(letters, size if exponent > 0 else to.negative(size))


def html(above: Powers, below: Powers) -> str:
    """The unit as text with raised exponents, "" if it is dimensionless."""
    if not below:
        return _html(above)
    under = _html(below)
    return f"{_html(above) or '1'}/{f'({under})' if len(below) > 1 else under}"


def _html(powers: Powers) -> str:
    raised = [symbol if n == 1 else f"{symbol}<sup>{str(n).replace('-', '−')}</sup>" for symbol, n in powers]
    return "·".join(raised)
