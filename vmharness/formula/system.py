"""A consistent system of units: one unit each of length, time, mass and force with F = M L / T^2."""

from dataclasses import dataclass, field
from fractions import Fraction

from vmharness.formula.dimension import FORCE, LENGTH, MASS, TEMPERATURE, TIME, Dimension, product_text
from vmharness.formula.error import UnitError
from vmharness.formula.unit import Unit
from vmharness.formula.unit_symbols import SYMBOLS


@dataclass(frozen=True)
class UnitSystem:
    """A consistent system, given by length, time and either mass or force (both if they agree).

    >>> inch = UnitSystem(length="in", force="lbf", time="s")
    >>> inch.factor("ft"), inch.name(Unit("kg").dimension), inch.name(Unit("J").dimension)
    (12.0, 'lbf-s2/in', 'lbf-in')
    """

    length: str
    time: str
    mass: str = ""
    force: str = ""
    temperature: str = "K"
    _scale: dict[str, Fraction] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        length, time = _base(self.length, "length", LENGTH), _base(self.time, "time", TIME)
        if not (self.mass or self.force):
            raise UnitError("a system of units needs a mass or a force")
        if self.mass:
            mass = _base(self.mass, "mass", MASS)
        else:
            mass = _base(self.force, "force", FORCE) * time**2 / length
        force = mass * length / time**2
        if self.force and _base(self.force, "force", FORCE) != force:
            raise UnitError(
                f"{self.force} does not give {self.mass} an acceleration of {self.length}/{self.time}2; "
                "give the mass or the force"
            )
        temperature = _base(self.temperature, "temperature", TEMPERATURE)
        scale = {"mass": mass, "length": length, "time": time, "temperature": temperature}
        object.__setattr__(self, "_scale", scale)
        # The other of mass and force may have a symbol of its own: kN for mm, ms, kg; slug for ft, s, lbf.
        object.__setattr__(self, "mass", self.mass or _symbol(mass, MASS))
        object.__setattr__(self, "force", self.force or _symbol(force, FORCE))

    def factor(self, unit: Unit | str) -> float:
        """How many consistent units one `unit` is; 1.0 exactly for a consistent unit."""
        unit = unit if isinstance(unit, Unit) else Unit(unit)
        consistent = Fraction(1)
        for scale, exponent in zip(self._scale.values(), unit.dimension.exponents(), strict=True):
            consistent *= Fraction(scale**exponent)
        return float(unit.exact_factor() / consistent)

    def name(self, dimension: Dimension) -> str:
        """The consistent unit of `dimension` in the system's own symbols, "" if it is dimensionless.

        Of a name with mass and one with force (M = F T^2 / L) the one with the smaller exponents is taken.
        """
        mass, length, time, temperature = dimension.exponents()
        rest = (self.temperature, temperature)
        names = []
        if self.force or mass == 0:
            names.append(
                [(self.force, mass), (self.length, length - mass), (self.time, time + 2 * mass), rest]
            )
        if self.mass:
            names.append([(self.mass, mass), (self.length, length), (self.time, time), rest])
        return product_text(min(names, key=lambda powers: sum(abs(n) for _, n in powers)))


def _base(text: str, what: str, dimension: Dimension) -> Fraction:
    """Exact SI factor of a base unit, which must be one symbol of the right dimension."""
    unit = Unit(text)
    if unit.dimension != dimension or text not in SYMBOLS:
        raise UnitError(f"{what} = {text}: a unit symbol of {what} is expected")
    return unit.exact_factor()


def _symbol(factor: Fraction, dimension: Dimension) -> str:
    """The symbol of a unit with this factor and dimension, "" if there is none."""
    return next((symbol for symbol, known in SYMBOLS.items() if known == (factor, dimension)), "")
