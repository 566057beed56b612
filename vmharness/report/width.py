"""Width of a formula before a browser sets it, so that the page can make a long one smaller instead of cutting it."""

from collections.abc import Callable, Mapping
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

LETTER, DIGIT, SIGN, FENCE = 0.68, 0.66, 1.4, 0.5  # em, as wide as any font of the page sets them
SMALL = 0.75  # size of a script, and of a fraction within a line


def ems(mathml: str) -> float:
    """The width of a <math> element in em, rather too large than too small.

    >>> ems("<math><mi>x</mi><mo>=</mo><mfrac><mn>1</mn><mn>386</mn></mfrac></math>")
    4.26
    """
    return round(_width(ElementTree.fromstring(mathml)), 2)


def _width(element: Element) -> float:
    widths = [_width(child) for child in element]
    if element.tag in RULES:
        return RULES[element.tag](element, widths)
    return sum(widths)


def _table(element: Element, _: list[float]) -> float:
    """The widest cell of each column, with its margins."""
    rows = [[_width(cell) for cell in row] for row in element]
    return sum(max(column) + 1.0 for column in zip(*rows, strict=True))


def _space(element: Element, _: list[float]) -> float:
    return float(element.attrib["width"].removesuffix("em"))


def _operator(element: Element, _: list[float]) -> float:
    return FENCE if element.get("fence") or element.text in ("(", ")", ",") else SIGN


RULES: Mapping[str, Callable[[Element, list[float]], float]] = {
    "mi": lambda element, _: LETTER * len(element.text or ""),
    "mn": lambda element, _: DIGIT * len(element.text or ""),
    "mtext": lambda element, _: LETTER * len(element.text or ""),
    "mo": _operator,
    "mspace": _space,
    "mfrac": lambda _, widths: max(widths) + 0.2,
    "msub": lambda _, widths: widths[0] + SMALL * widths[1],
    "msup": lambda _, widths: widths[0] + SMALL * widths[1],
    "msqrt": lambda _, widths: sum(widths) + 1.0,
    "mroot": lambda _, widths: widths[0] + 1.2,
    "mover": lambda _, widths: widths[0],
    "munderover": lambda _, widths: max(widths[0], SMALL * widths[1], SMALL * widths[2]),
    "mtable": _table,
}
