"""Units as engineers write them."""

import pytest

from vmharness.formula import Unit, UnitError


@pytest.mark.parametrize(
    ("one", "same"),
    [
        ("psi", "lbf/in2"),
        ("ksi", "kip/in2"),
        ("lbf", "slug-ft/s2"),
        ("N", "kg-m/s2"),
        ("J", "N-m"),
        ("mJ", "mN-m"),
        ("W", "J/s"),
        ("Pa", "N/m2"),
        ("MPa", "N/mm2"),
        ("GPa", "kN/mm2"),
        ("kN", "kg-mm/ms2"),
        ("kN", "g-m/ms2"),
        ("MN", "t-km/s2"),
        ("t", "tonne"),
        ("h", "hr"),
        ("kHz", "1/ms"),
        ("rpm", "rev/min"),
        ("R", "F"),
    ],
)
def test_identities_are_exact(one: str, same: str) -> None:
    assert Unit(one).exact_factor() == Unit(same).exact_factor()
    assert Unit(one).dimension == Unit(same).dimension


@pytest.mark.parametrize(
    ("text", "factor"),
    [
        ("in", 0.0254),
        ("ft", 0.3048),
        ("lbf", 4.4482216152605),
        ("lbm", 0.45359237),
        ("slug", 14.593902937206364),
        ("psi", 6894.757293168361),
        ("deg", 0.017453292519943295),
        ("rev", 6.283185307179586),
        ("kip", 4448.2216152605),
        ("Btu/hr-ft-F", 1.7307346663713912),
        ("min", 60.0),
        ("um", 1e-6),
        ("µm", 1e-6),
        ("mg", 1e-6),
        ("lbf-s2/in", 175.12683524647635),
    ],
)
def test_factors_to_si(text: str, factor: float) -> None:
    assert Unit(text).factor == pytest.approx(factor, rel=1e-15)


def test_prefixes_are_not_confused() -> None:
    assert (Unit("mN").factor, Unit("MN").factor) == (1e-3, 1e6)
    assert (Unit("mJ").factor, Unit("MJ").factor) == (1e-3, 1e6)
    assert Unit("min").dimension == Unit("s").dimension != Unit("m-in").dimension
    assert Unit("ms").dimension == Unit("s").dimension != Unit("m-s").dimension
    assert (Unit("t").factor, Unit("ft").factor) == (1000.0, 0.3048)
    assert Unit("g").dimension == Unit("kg").dimension


@pytest.mark.parametrize(
    "text", ["lbf-s2/in", "lbf*s^2/in", "lbf s**2/in", "lbf·s²/in", "lbf.s2/in", " s2-lbf / in "]
)
def test_ways_of_writing_one_unit(text: str) -> None:
    assert Unit(text).dimension == Unit("lbf-s2/in").dimension
    assert Unit(text).exact_factor() == Unit("lbf-s2/in").exact_factor()
    assert Unit(text).text == str(Unit(text)) == text


@pytest.mark.parametrize("text", ["", "1", "-", " "])
def test_dimensionless(text: str) -> None:
    assert Unit(text).dimension == Unit("rad").dimension
    assert Unit(text).factor == 1.0
    assert Unit(text).latex() == Unit(text).mathml() == Unit(text).html() == ""


@pytest.mark.parametrize("text", ["1/s", "s^-1", "s**-1", "/s", "1 / s", "s^(-1)", "s^-1.0"])
def test_ways_of_writing_one_over_second(text: str) -> None:
    assert Unit(text).dimension == Unit("Hz").dimension


def test_all_after_the_slash_is_denominator() -> None:
    assert Unit("W/m2-K").dimension == Unit("W/(m2-K)").dimension == Unit("W-m^-2-K^-1").dimension


def test_fractional_exponents() -> None:
    assert Unit("MPa-m^0.5").dimension == Unit("MPa-m^(1/2)").dimension
    assert Unit("mm^(1/2)").factor == pytest.approx(0.001**0.5, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("m/s/s", "unit `m/s/s`: a second / is ambiguous; write a-b/c-d"),
        ("kPA", "unit `kPA`: kPA is not known; did you mean kPa"),
        ("Lbf-s2/in", "unit `Lbf-s2/in`: Lbf is not known; did you mean lbf"),
        ("lb", "unit `lb`: lb is ambiguous; write lbf (force) or lbm (mass)"),
        ("ton", "unit `ton`: ton is ambiguous; write t (1000 kg)"),
        ("s-2", "a symbol is expected at `2`; write s2, s^-2 or 1/s2"),
        ("m-", "a symbol is expected at `the end`"),
        ("m/", "a symbol is expected at `the end`"),
        ("m^", "`^` is not understood"),
        ("m0", "exponent of m"),
        ("m^(1/0)", "exponent of m"),
        ("m99999999", "exponent of m"),
        ("2m", "a symbol is expected at `2m`"),
        ("m" * 200, "longer than 100 characters"),
        ("m(s)", "`(s)` is not understood"),
    ],
)
def test_errors(text: str, message: str) -> None:
    with pytest.raises(UnitError) as error:
        Unit(text)
    assert message in str(error.value)


def test_typesetting() -> None:
    assert Unit("lbf-s2/in").html() == "lbf·s<sup>2</sup>/in"
    assert Unit("Btu/hr-ft-F").html() == "Btu/(hr·ft·F)"
    assert Unit("s^-1").html() == "s<sup>−1</sup>"
    assert Unit("1/s").html() == "1/s"
    assert Unit("lbf-s2/in").latex() == r"\mathrm{lbf} \cdot \mathrm{s}^{2} / \mathrm{in}"
    assert Unit("m/s2").mathml() == (
        '<mrow><mi mathvariant="normal">m</mi><mo>/</mo>'
        '<msup><mi mathvariant="normal">s</mi><mn>2</mn></msup></mrow>'
    )
