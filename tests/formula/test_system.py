"""Consistent systems of units."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.formula import DIMENSIONLESS, Dimension, Unit, UnitError, UnitSystem

INCH = UnitSystem(length="in", force="lbf", time="s")
MILLI = UnitSystem(length="mm", mass="kg", time="ms")
TONNE = UnitSystem(length="mm", mass="t", time="s")
SI = UnitSystem(length="m", mass="kg", time="s")
FOOT = UnitSystem(length="ft", force="lbf", time="s")

halves = st.integers(-8, 8).map(lambda n: Fraction(n, 2))


@pytest.mark.parametrize(
    ("unit", "name"),
    [
        ("m", "in"),
        ("m/s", "in/s"),
        ("m/s2", "in/s2"),
        ("kg", "lbf-s2/in"),
        ("N", "lbf"),
        ("J", "lbf-in"),
        ("N/m", "lbf/in"),
        ("Pa", "lbf/in2"),
        ("kg/m3", "lbf-s2/in4"),
        ("N-s/m", "lbf-s/in"),
        ("kg-m2", "lbf-in-s2"),
        ("Hz", "1/s"),
        ("rad", ""),
    ],
)
def test_names_of_the_manual(unit: str, name: str) -> None:
    assert INCH.name(Unit(unit).dimension) == name


def test_names_take_the_shorter_of_mass_and_force() -> None:
    names = [MILLI.name(Unit(unit).dimension) for unit in ("kg", "N", "Pa", "J", "kg/m3", "N/m")]
    assert names == ["kg", "kN", "kN/mm2", "kN-mm", "kg/mm3", "kN/mm"]
    assert TONNE.force == SI.force == "N"
    assert FOOT.name(Unit("kg").dimension) == "slug"


@pytest.mark.parametrize("system", [INCH, MILLI, TONNE, SI, FOOT])
@given(exponents=st.tuples(halves, halves, halves, halves))
def test_a_name_is_a_consistent_unit(system: UnitSystem, exponents: tuple[Fraction, ...]) -> None:
    dimension = Dimension(*(e / 2 for e in exponents))
    unit = Unit(system.name(dimension))
    assert unit.dimension == dimension
    assert system.factor(unit) == pytest.approx(1.0, rel=1e-13)


def test_consistent_units_have_factor_one_exactly() -> None:
    assert [INCH.factor(u) for u in ("in", "s", "lbf", "lbf-s2/in", "psi", "lbf-in", "1")] == [1.0] * 7
    assert [MILLI.factor(u) for u in ("mm", "ms", "kg", "kN", "GPa", "J", "m/s", "1/ms")] == [1.0] * 8
    assert [TONNE.factor(u) for u in ("t/mm3", "MPa", "N", "mJ")] == [1.0] * 4


def test_factors() -> None:
    assert INCH.factor("ft") == 12.0
    assert INCH.factor(Unit("ksi")) == 1000.0
    assert INCH.factor("slug") == pytest.approx(1 / 12, rel=1e-15)
    assert MILLI.factor("g/cm3") == 1e-6
    assert INCH.factor("deg") == pytest.approx(0.017453292519943295, rel=1e-15)
    assert SI.name(DIMENSIONLESS) == ""


def test_mass_and_force_must_agree() -> None:
    assert UnitSystem(length="mm", mass="kg", force="kN", time="ms") == MILLI
    with pytest.raises(UnitError, match="N does not give kg an acceleration of mm/ms2"):
        UnitSystem(length="mm", mass="kg", force="N", time="ms")
    with pytest.raises(UnitError, match="needs a mass or a force"):
        UnitSystem(length="mm", time="ms")


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        ({"length": "s"}, "length = s: a unit symbol of length is expected"),
        ({"time": "1/Hz"}, "time = 1/Hz"),
        ({"force": "kg"}, "force = kg"),
        ({"temperature": "m"}, "temperature = m"),
        ({"length": "inch"}, "did you mean"),
    ],
)
def test_base_units_are_symbols_of_their_kind(bad: dict[str, str], message: str) -> None:
    with pytest.raises(UnitError, match=message):
        UnitSystem(**{"length": "in", "time": "s", "force": "lbf", **bad})
