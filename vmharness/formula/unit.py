"""Units of measurement as engineers write them: `lbf-s2/in`, `Btu/hr-ft-F`, `kN/mm^2`."""

import math
import re
from dataclasses import dataclass, field
from fractions import Fraction

from vmharness.formula import latex, mathml
from vmharness.formula.dimension import DIMENSIONLESS, Dimension
from vmharness.formula.error import UnitError, suggestion
from vmharness.formula.unit_symbols import AMBIGUOUS, SYMBOLS
from vmharness.formula.unit_typeset import html, unit_in

_FACTOR = re.compile(r"([A-Za-z]+)(\d+|(?:\^|\*\*)(?:([-+]?\d+(?:\.\d+)?)|\(([-+]?\d+(?:/\d+)?)\)))?")
_SLASH = re.compile(r"/(?!\d+\))")  # not that of an exponent such as ^(1/2)
_SEPARATOR = re.compile(r"\s*[-*.·]\s*|\s+")


@dataclass(frozen=True)
class Unit:
    """A unit, printed as it was written; `factor` turns a value in it into SI.

    Products are written with `-`, `*`, `.`, `·` or a blank; all that follows the one `/` is the denominator;
    exponents are `s2`, `s^2`, `s**-2`. Dimensionless: "", "1", "-". Raises UnitError.

    >>> Unit("lbf-s2/in").dimension == Unit("kg").dimension
    True
    >>> Unit("in").factor
    0.0254
    """

    text: str
    above: tuple[tuple[str, Fraction], ...] = field(init=False, repr=False, compare=False)
    below: tuple[tuple[str, Fraction], ...] = field(init=False, repr=False, compare=False)
    dimension: Dimension = field(init=False, repr=False, compare=False)
    factor: float = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        text = self.text.strip().translate({ord("²"): "2", ord("³"): "3", ord("µ"): "u", ord("μ"): "u"})
        if len(text) > 100:
            raise UnitError(f"unit `{text[:30]}...`: longer than 100 characters")
        above, *below = _SLASH.split(text)
        if len(below) > 1:
            raise UnitError(f"unit `{self.text}`: a second / is ambiguous; write a-b/c-d")
        above_line = () if above.strip() in ("", "1", "-") else _product(above, self.text)
        below_line = _product(_bare(below[0]), self.text) if below else ()
        object.__setattr__(self, "above", above_line)
        object.__setattr__(self, "below", below_line)
        dimensions = (SYMBOLS[symbol][1] ** n for symbol, n in self.powers())
        object.__setattr__(self, "dimension", math.prod(dimensions, start=DIMENSIONLESS))
        object.__setattr__(self, "factor", float(self.exact_factor()))

    def powers(self) -> tuple[tuple[str, Fraction], ...]:
        """Symbols with their exponents, those below the line negative."""
        return self.above + tuple((symbol, -n) for symbol, n in self.below)

    def exact_factor(self) -> Fraction:
        """The factor to SI as a fraction, exact unless an exponent is fractional or pi is in it."""
        factors = (Fraction(SYMBOLS[symbol][0] ** n) for symbol, n in self.powers())
        return math.prod(factors, start=Fraction(1))

    def __str__(self) -> str:
        return self.text

    def latex(self) -> str:
        """LaTeX without its dollars, "" if dimensionless."""
        return unit_in(self.above, self.below, latex)

    def mathml(self) -> str:
        """The content of a <math> element, "" if dimensionless."""
        return unit_in(self.above, self.below, mathml)

    def html(self) -> str:
        """Text with raised exponents.

        >>> Unit("lbf-s2/in").html()
        'lbf·s<sup>2</sup>/in'
        """
        return html(self.above, self.below)


def _bare(text: str) -> str:
    """The denominator without the parentheses that may enclose all of it."""
    text = text.strip()
    return text[1:-1] if text.startswith("(") and text.endswith(")") else text


def _product(text: str, unit: str) -> tuple[tuple[str, Fraction], ...]:
    """The factors of a product of powers; `unit` is the whole text, for messages."""
    powers, at, text = [], 0, text.strip()
    while True:
        found = _FACTOR.match(text, at)
        if not found:
            raise UnitError(
                f"unit `{unit}`: a symbol is expected at `{text[at:] or 'the end'}`; write s2, s^-2 or 1/s2"
            )
        powers.append((_known(found[1], unit), _exponent(found, unit)))
        at = found.end()
        if at == len(text):
            return tuple(powers)
        separator = _SEPARATOR.match(text, at)
        if not separator:
            raise UnitError(
                f"unit `{unit}`: `{text[at:]}` is not understood; write products as a-b, powers as s2"
            )
        at = separator.end()


def _exponent(found: re.Match[str], unit: str) -> Fraction:
    """The exponent of a factor, at most 12 in size."""
    try:
        exponent = Fraction(found[4] or found[3] or found[2] or 1)
    except ZeroDivisionError:
        exponent = Fraction(0)
    if not 0 < abs(exponent) <= 12 or exponent.denominator > 12:
        raise UnitError(
            f"unit `{unit}`: exponent of {found[1]}: a number between 1/12 and 12 in size is expected"
        )
    return exponent


def _known(symbol: str, unit: str) -> str:
    """`symbol` if it is in the table; case matters: mN is a thousandth of a newton, MN a million."""
    if symbol in AMBIGUOUS:
        raise UnitError(f"unit `{unit}`: {symbol} is ambiguous; write {AMBIGUOUS[symbol]}")
    if symbol not in SYMBOLS:
        raise UnitError(f"unit `{unit}`: {symbol} is not known; {suggestion(symbol, SYMBOLS)}")
    return symbol
