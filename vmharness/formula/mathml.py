"""The MathML of the parts of a formula: the elements of MathML Core, which browsers draw without a script."""

from collections.abc import Sequence

from vmharness.formula.symbol import GREEK, Symbol

SIGNS = {"<": "&lt;", "<=": "≤", ">": "&gt;", ">=": "≥", "==": "=", "!=": "≠", "-": "−", "in": "∈"}
SPACE = '<mspace width="{}em"/>'
ACCENTS = {"dot": "˙", "ddot": "¨", "bar": "¯"}


def row(*parts: str) -> str:
    written = [part for part in parts if part]
    return written[0] if len(written) == 1 else f"<mrow>{''.join(written)}</mrow>"


def sign(text: str) -> str:
    if text in ("times", "gap"):
        return SPACE.format("0.17" if text == "times" else "0.5")
    if text in ("and", "or", "not"):
        return SPACE.format("0.5") + f"<mtext>{text}</mtext>" + SPACE.format("0.5")
    return f"<mo>{SIGNS.get(text, text)}</mo>"


def infix(text: str) -> str:
    # At the start of a row a browser takes + and - for signs of a number, unless they are said to stand between terms.
    return f'<mo form="infix">{SIGNS.get(text, text)}</mo>'


def negative(operand: str) -> str:
    return row(sign("-"), operand)


def number(digits: str) -> str:
    return f"<mn>{digits}</mn>"


def upright(text: str) -> str:
    return f'<mi mathvariant="normal">{text}</mi>' if len(text) == 1 else f"<mi>{text}</mi>"


def name(parts: Symbol) -> str:
    base = _letters(parts.base)
    if parts.accent:
        base = f'<mover accent="true">{base}<mo>{ACCENTS[parts.accent]}</mo></mover>'
    if not parts.subscripts:
        return base
    first, *rest = map(_letters, parts.subscripts)
    return subscript(base, row(first, *(sign(",") + other for other in rest)))


def _letters(text: str) -> str:
    return number(text) if text.isdigit() else f"<mi>{GREEK.get(text, text)}</mi>"


def subscript(base: str, below: str) -> str:
    return f"<msub>{base}{below}</msub>"


def power(base: str, exponent: str) -> str:
    return f"<msup>{base}{exponent}</msup>"


def fraction(above: str, below: str) -> str:
    return f"<mfrac>{above}{below}</mfrac>"


def radical(inside: str, degree: str = "") -> str:
    return f"<mroot>{inside}{degree}</mroot>" if degree else f"<msqrt>{inside}</msqrt>"


def fenced(inside: str, fence: str = "()") -> str:
    left, right = fence[0], fence[1]
    return f'<mrow><mo fence="true">{left}</mo>{inside}<mo fence="true">{right}</mo></mrow>'


def function(word: str) -> str:
    return f"<mi>{word}</mi>"


def summation(below: str, above: str) -> str:
    return f"<munderover><mo>∑</mo>{below}{above}</munderover>"


def cases(rows: Sequence[tuple[str, str]]) -> str:
    cell = '<mtd style="text-align: left; padding: 0.2em 0.5em">{}</mtd>'
    lines = "".join(f"<mtr>{cell.format(value)}{cell.format(when)}</mtr>" for value, when in rows)
    return f'<mrow><mo fence="true" form="prefix">{{</mo><mtable displaystyle="true">{lines}</mtable></mrow>'


def when(condition: str) -> str:
    return f"<mrow><mtext>if</mtext>{SPACE.format('0.5')}{condition}</mrow>"


def display(content: str) -> str:
    return f'<math display="block">{content}</math>'
