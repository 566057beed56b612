"""The LaTeX of the parts of a formula.

Only commands of letters are used: Markdown has its own meaning for a backslash before punctuation.
"""

from collections.abc import Sequence

from vmharness.formula.symbol import GREEK, Symbol

SIGNS = {
    "<": r"\lt",
    "<=": r"\le",
    ">": r"\gt",
    ">=": r"\ge",
    "==": "=",
    "!=": r"\ne",
    "in": r"\in",
    "·": r"\cdot",
    "and": r"\enspace\mathrm{and}\enspace",
    "or": r"\enspace\mathrm{or}\enspace",
    "not": r"\mathrm{not}\enspace",
    "times": r"\thinspace",
    "gap": r"\enspace",
}
FENCES = {"()": ("(", ")"), "||": (r"\vert", r"\vert"), "[]": ("[", "]"), "{}": (r"\lbrace", r"\rbrace")}
FUNCTIONS = {
    "sin",
    "cos",
    "tan",
    "arcsin",
    "arccos",
    "arctan",
    "sinh",
    "cosh",
    "tanh",
    "ln",
    "log",
    "min",
    "max",
}


def row(*parts: str) -> str:
    return " ".join(part for part in parts if part)


def sign(text: str) -> str:
    return SIGNS.get(text, text)


def infix(text: str) -> str:
    return sign(text)


def negative(operand: str) -> str:
    return "-" + operand


def number(digits: str) -> str:
    return digits


def upright(text: str) -> str:
    return rf"\mathrm{{{text}}}"


def name(parts: Symbol) -> str:
    base = _letters(parts.base)
    if parts.accent:
        base = rf"\{parts.accent}{{{base}}}"
    return subscript(base, ", ".join(map(_letters, parts.subscripts))) if parts.subscripts else base


def _letters(text: str) -> str:
    if text in GREEK:
        return "\\" + text
    return text if len(text) == 1 or text.isdigit() else upright(text)


def subscript(base: str, below: str) -> str:
    return f"{base}_{{{below}}}"


def power(base: str, exponent: str) -> str:
    # A base that ends in a superscript of its own, such as \sin^2, is fenced by the caller.
    return f"{base}^{{{exponent}}}"


def fraction(above: str, below: str) -> str:
    return rf"\frac{{{above}}}{{{below}}}"


def radical(inside: str, degree: str = "") -> str:
    return rf"\sqrt[{degree}]{{{inside}}}" if degree else rf"\sqrt{{{inside}}}"


def fenced(inside: str, fence: str = "()") -> str:
    left, right = FENCES[fence]
    return rf"\left{left} {inside} \right{right}"


def function(word: str) -> str:
    return "\\" + word if word in FUNCTIONS else upright(word)


def summation(below: str, above: str) -> str:
    return rf"\sum_{{{below}}}^{{{above}}}"


def cases(rows: Sequence[tuple[str, str]]) -> str:
    lines = r" \cr ".join(rf"{value} & {when}" for value, when in rows)
    return rf"\begin{{cases}} {lines} \end{{cases}}"


def when(condition: str) -> str:
    return rf"\mathrm{{if}}\enspace {condition}"


def display(content: str) -> str:
    return content
