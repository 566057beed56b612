"""Physical dimensions: rational exponents of mass, length, time and temperature."""

from dataclasses import dataclass
from fractions import Fraction

ZERO = Fraction(0)


@dataclass(frozen=True)
class Dimension:
    """M^mass L^length T^time Theta^temperature; an angle has no dimension.

    >>> velocity = Dimension(length=Fraction(1)) / Dimension(time=Fraction(1))
    >>> str(velocity**2)
    'length2/time2'
    """

    mass: Fraction = ZERO
    length: Fraction = ZERO
    time: Fraction = ZERO
    temperature: Fraction = ZERO

    def exponents(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """The exponents of mass, length, time and temperature."""
        return self.mass, self.length, self.time, self.temperature

    def __mul__(self, other: "Dimension") -> "Dimension":
        return Dimension(*(a + b for a, b in zip(self.exponents(), other.exponents(), strict=True)))

    def __truediv__(self, other: "Dimension") -> "Dimension":
        return Dimension(*(a - b for a, b in zip(self.exponents(), other.exponents(), strict=True)))

    def __pow__(self, exponent: Fraction | int) -> "Dimension":
        return Dimension(*(a * exponent for a in self.exponents()))

    def __str__(self) -> str:
        names = ("mass", "length", "time", "temperature")
        return product_text(list(zip(names, self.exponents(), strict=True))) or "dimensionless"


DIMENSIONLESS = Dimension()
MASS = Dimension(mass=Fraction(1))
LENGTH = Dimension(length=Fraction(1))
TIME = Dimension(time=Fraction(1))
TEMPERATURE = Dimension(temperature=Fraction(1))
FORCE = MASS * LENGTH / TIME**2


def product_text(powers: list[tuple[str, Fraction]]) -> str:
    """A product of powers as engineers write it, or "" if every exponent is zero.

    >>> product_text([("lbf", Fraction(1)), ("in", Fraction(-1)), ("s", Fraction(2))])
    'lbf-s2/in'
    >>> product_text([("s", Fraction(-1))])
    '1/s'
    """
    above = "-".join(name + exponent_text(n) for name, n in powers if n > 0)
    below = "-".join(name + exponent_text(-n) for name, n in powers if n < 0)
    if not below:
        return above
    return f"{above or '1'}/{below}"


def exponent_text(exponent: Fraction) -> str:
    """A positive exponent: "" for one, "2" for two, "^(1/2)" for a half."""
    if exponent == 1:
        return ""
    return str(exponent) if exponent.denominator == 1 else f"^({exponent})"
