"""How formulas look."""

import pytest

from vmharness.formula import Formula, FormulaError, Unit, equation, pieces


def tidy(latex: str) -> str:
    """LaTeX with thin spaces as `,` and without the blanks and fences' sizes that do not matter."""
    return latex.replace(r"\thinspace", ",").replace(r"\left", "").replace(r"\right", "").replace(" ", "")


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("2*h/g", r"\frac{2,h}{g}"),
        ("-g*t^2/2", r"-\frac{g,t^{2}}{2}"),
        ("(a + b)*c", "(a+b),c"),
        ("a*(b*c)", "a,b,c"),
        ("a*(b/c)", r"a,\frac{b}{c}"),
        ("(a/b)**2", r"(\frac{a}{b})^{2}"),
        ("a**(b + c)", "a^{b+c}"),
        ("(a**b)**c", "(a^{b})^{c}"),
        ("a**b**c", "a^{b^{c}}"),
        ("(-a)**2", "(-a)^{2}"),
        ("-a**2", "-a^{2}"),
        ("a - (b - c)", "a-(b-c)"),
        ("a - b + c", "a-b+c"),
        ("a + -b", "a+(-b)"),
        ("a*-b", "a,(-b)"),
        ("(a + b)/(c - d)", r"\frac{a+b}{c-d}"),
        ("2*3", r"2\cdot3"),
        ("x*2*y", r"x\cdot2,y"),
        ("2*(1/3)", r"2\cdot\frac{1}{3}"),
        ("2*3**n", r"2\cdot3^{n}"),
        ("2*(a + b)", "2,(a+b)"),
        ("1.5e-3*x", r"1.5\cdot10^{-3},x"),
        ("1e6", "10^{6}"),
        ("x**1e2", "x^{10^{2}}"),
        ("1e6**2", "(10^{6})^{2}"),
        ("sqrt(k/m)", r"\sqrt{\frac{k}{m}}"),
        ("sqrt(x)**2", r"(\sqrt{x})^{2}"),
        ("cbrt(x)", r"\sqrt[3]{x}"),
        ("exp(-zeta*t)", r"\mathrm{e}^{-\zeta,t}"),
        ("exp(x)**2", r"(\mathrm{e}^{x})^{2}"),
        ("sin(omega*t)**2", r"\sin^{2}(\omega,t)"),
        ("sin(x)**n", r"\sin(x)^{n}"),
        ("abs(x)*pi", r"\vertx\vert,\pi"),
        ("log(x) + log10(y)", r"\ln(x)+\log_{10}(y)"),
        ("asin(x) + atan2(y, x)", r"\arcsin(x)+\mathrm{atan2}(y,x)"),
        ("sign(x)*max(a, b, c)", r"\mathrm{sgn}(x),\max(a,b,c)"),
        ("besselj(0, x)*ellipk(m)", r"J_{0}(x),K(m)"),
        ("sum(a + n, n, 1, N)", r"\sum_{n=1}^{N}(a+n)"),
        ("sum(a*n, n, 1, N)", r"\sum_{n=1}^{N}a,n"),
        ("root(tan(x) - 1, x, 0, 1)", r"\lbracex\in[0,1]:\tan(x)-1=0\rbrace"),
    ],
)
def test_latex(text: str, latex: str) -> None:
    assert tidy(Formula(text).latex()) == latex


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("v0", "v_{0}"),
        ("t_impact", r"t_{\mathrm{impact}}"),
        ("omega", r"\omega"),
        ("omega_d", r"\omega_{d}"),
        ("Omega2", r"\Omega_{2}"),
        ("sigma_theta", r"\sigma_{\theta}"),
        ("z_max_1", r"z_{\mathrm{max}, 1}"),
        ("x1_dot", r"\dot{x}_{1}"),
        ("z_ddot", r"\ddot{z}"),
        ("ke_impact", r"\mathrm{ke}_{\mathrm{impact}}"),
        ("lambda", r"\lambda"),
        ("a_", "a"),
    ],
)
def test_names(name: str, latex: str) -> None:
    assert Formula(name).latex() == latex


def test_nested_where_is_one_block_of_cases() -> None:
    f = Formula("where(t < t1, 0, where(t1 <= t < t2 and not x == 0, -h, where(t != 1 or t > 9, 1, 2)))")
    assert tidy(f.latex()) == tidy(
        r"\begin{cases} 0 & \mathrm{if}\enspace t \lt t_{1}"
        r" \cr -h & \mathrm{if}\enspace t_{1} \le t \lt t_{2} \enspace\mathrm{and}\enspace \mathrm{not}\enspace x = 0"
        r" \cr 1 & \mathrm{if}\enspace t \ne 1 \enspace\mathrm{or}\enspace t \gt 9"
        r" \cr 2 & \mathrm{otherwise} \end{cases}"
    )
    assert f.mathml().count("<mtable") == 1
    assert f.mathml().count("<mtr>") == 4


def test_cases_that_are_an_operand_are_fenced() -> None:
    assert tidy(Formula("2*where(t < 1, 0, 1)").latex()).startswith(r"2,(\begin{cases}")


def test_values_in_the_places_of_names() -> None:
    f = Formula("sqrt(2*h/g)")
    assert f.latex(values={"h": "1", "g": "386"}) == r"\sqrt{\frac{2 \cdot 1}{386}}"
    assert tidy(Formula("a*b**2 - c").latex(values={"a": "-2", "b": "-3", "c": "-1.5e-3"})) == (
        r"(-2),(-3)^{2}-(-1.5\cdot10^{-3})"
    )
    assert tidy(Formula("sum(n*a, n, 1, n)").latex(values={"n": "5", "a": "7"})) == r"\sum_{n=1}^{5}n\cdot7"
    with pytest.raises(FormulaError, match="`1 in` is not a number"):
        f.latex(values={"h": "1 in"})


def test_other_symbols() -> None:
    assert Formula("ke + v0").latex(symbols={"ke": "T_1"}) == "T_{1} + v_{0}"
    assert Formula("ke").mathml(symbols={"ke": "T"}) == "<mi>T</mi>"


def test_mathml() -> None:
    assert Formula("-v0**2/omega").mathml() == (
        "<mrow><mo>−</mo><mfrac><msup><msub><mi>v</mi><mn>0</mn></msub><mn>2</mn></msup><mi>ω</mi></mfrac></mrow>"
    )
    assert Formula("t_impact").mathml() == "<msub><mi>t</mi><mi>impact</mi></msub>"
    assert Formula("where(a < b, 1, 2)").mathml().count("<mo>&lt;</mo>") == 1


def test_equation() -> None:
    line = equation("t_impact", Formula("sqrt(2*h/g)"), "0.0719816", Unit("s"), values={"h": "1", "g": "386"})
    assert line == (
        r"t_{\mathrm{impact}} = \sqrt{\frac{2 \thinspace h}{g}} = \sqrt{\frac{2 \cdot 1}{386}}"
        r" = 0.0719816 \thinspace \mathrm{s}"
    )
    drawn = equation("x", Formula("a/b"), "-2", Unit("in"), values={"a": "-4", "b": "2"}, notation="mathml")
    assert drawn.startswith('<math display="block"><mrow><mi>x</mi><mo>=</mo><mfrac>')
    assert drawn.count("<mo>=</mo>") == 3


def test_pieces_of_an_equation_are_its_steps_and_the_terms_of_their_sums() -> None:
    formula = Formula("where(a < b, 1, 2) - (a - b) + a*(b + 1)")
    values = {"a": "3", "b": "-4"}
    parts = pieces("x", formula, "-15", Unit("mm"), values=values, notation="latex")
    assert len(parts) == 7
    assert [part[0] for part in parts] == ["x", "-", "+", "=", "-", "+", "="]
    assert parts[-1] == r"= -15 \thinspace \mathrm{mm}"
    assert " ".join(parts) == equation("x", formula, "-15", Unit("mm"), values=values)
    assert pieces("h", Formula("2"), "2", notation="latex") == ["h = 2"]
    assert pieces("F", Formula("F"), notation="latex") == ["F"]


def test_the_sign_of_a_piece_stands_between_terms() -> None:
    first, second = pieces("x", Formula("a - b"))
    assert second == '<math display="block"><mrow><mo form="infix">−</mo><mi>b</mi></mrow></math>'
    assert first.startswith('<math display="block"><mrow><mi>x</mi><mrow><mo>=</mo>')


def test_equation_does_not_repeat_itself() -> None:
    assert equation("h", Formula("2"), "2", Unit("in")) == r"h = 2 \thinspace \mathrm{in}"
    assert equation("x", Formula("2*h")) == r"x = 2 \thinspace h"
    assert equation("x", Formula("2*h"), "4", Unit("1")) == r"x = 2 \thinspace h = 4"


def test_a_long_equation_is_not_repeated_with_values() -> None:
    long = " + ".join(["a*b"] * 40)
    line = equation("x", Formula(long), "240", values={"a": "2", "b": "3"})
    assert r"2 \cdot 3" not in line
    assert line.endswith("= 240")
