"""The dimension of a formula, checked through every operation."""

from collections.abc import Mapping
from fractions import Fraction

from vmharness.formula.dimension import DIMENSIONLESS, Dimension
from vmharness.formula.error import FormulaError, suggestion
from vmharness.formula.text import write
from vmharness.formula.tree import (
    Binary,
    Bound,
    Call,
    Comparison,
    Logic,
    Name,
    Negative,
    Node,
    Number,
    children,
)

ROOTS = {"sqrt": Fraction(1, 2), "cbrt": Fraction(1, 3)}


def dimension(node: Node, known: Mapping[str, Dimension]) -> Dimension | None:
    """Dimension of a node; None for a literal zero, which fits any; raises FormulaError if units do not agree."""
    match node:
        case Number(text):
            return DIMENSIONLESS if float(text) else None
        case Name("pi"):
            return DIMENSIONLESS
        case Name(name):
            if name not in known:
                raise FormulaError(f"`{name}` is not known; {suggestion(name, known)}")
            return known[name]
        case Negative(operand):
            return dimension(operand, known)
        case Binary("**", base, exponent):
            return _power(node, base, exponent, known)
        case Binary("*", left, right):
            return _definite(left, known) * _definite(right, known)
        case Binary("/", left, right):
            return _definite(left, known) / _definite(right, known)
        case Binary(operator, left, right):
            return _same(node, (left, right), known, f"both sides of {operator}")
        case Call(function, arguments):
            return _call(node, function, arguments, known)
        case Bound(function, body, variable, low, high):
            return _bound(node, function, body, variable, (low, high), known)
        case _:
            raise AssertionError(node)


def _definite(node: Node, known: Mapping[str, Dimension]) -> Dimension:
    """The dimension of a node; zero counts as dimensionless."""
    return dimension(node, known) or DIMENSIONLESS


def _same(node: Node, parts: tuple[Node, ...], known: Mapping[str, Dimension], who: str) -> Dimension | None:
    """The one dimension of all parts but literal zeros."""
    found = [dimension(part, known) for part in parts]
    definite = [d for d in found if d is not None]
    if len(set(definite)) > 1:
        sign = f" {node.operator} " if isinstance(node, Binary) else ", "
        dimensions = sign.join("0" if d is None else str(d) for d in found)
        raise FormulaError(f"in `{write(node)}`: {dimensions}: {who} must have the same unit")
    return definite[0] if definite else None


def _plain(node: Node, part: Node, known: Mapping[str, Dimension], who: str) -> None:
    """`part` must be dimensionless."""
    found = _definite(part, known)
    if found != DIMENSIONLESS:
        raise FormulaError(f"in `{write(node)}`: {who} must be dimensionless, `{write(part)}` is {found}")


def _power(node: Node, base: Node, exponent: Node, known: Mapping[str, Dimension]) -> Dimension:
    """The exponent is dimensionless; it is a literal rational number if the base has a dimension."""
    _plain(node, exponent, known, "the exponent")
    unit = _definite(base, known)
    if unit == DIMENSIONLESS:
        return unit
    number = rational(exponent)
    if number is None:
        raise FormulaError(
            f"in `{write(node)}`: `{write(base)}` is {unit}, so the exponent must be a number such as 3/2"
        )
    return unit**number


def rational(node: Node) -> Fraction | None:
    """The exact value of a signed number or of a fraction of two; None for any other node."""
    match node:
        case Number(text) if len(text) <= 20 and abs(float(text)) < 1e6 and "e" not in text.lower():
            return Fraction(text)
        case Negative(operand):
            value = rational(operand)
            return None if value is None else -value
        case Binary("/", left, right):
            above, below = rational(left), rational(right)
            return above / below if above is not None and below else None
        case _:
            return None


def _call(
    node: Node, function: str, arguments: tuple[Node, ...], known: Mapping[str, Dimension]
) -> Dimension | None:
    """The dimension of the value of a function, from those of its arguments."""
    match function:
        case "sqrt" | "cbrt":
            return _definite(arguments[0], known) ** ROOTS[function]
        case "abs":
            return dimension(arguments[0], known)
        case "sign":
            dimension(arguments[0], known)
            return DIMENSIONLESS
        case "min" | "max":
            return _same(node, arguments, known, f"all arguments of {function}")
        case "atan2":
            _same(node, arguments, known, "both arguments of atan2")
            return DIMENSIONLESS
        case "where":
            _condition(arguments[0], known)
            return _same(node, arguments[1:], known, "both branches of where")
    for argument in arguments:
        _plain(node, argument, known, f"the argument of {function}")
    return DIMENSIONLESS


def _condition(node: Node, known: Mapping[str, Dimension]) -> None:
    """Check that comparisons have equal units on both sides."""
    match node:
        case Comparison(_, operands):
            _same(node, operands, known, "what is compared")
        case Logic():
            for part in children(node):
                _condition(part, known)


def _bound(
    node: Node,
    function: str,
    body: Node,
    variable: str,
    ends: tuple[Node, Node],
    known: Mapping[str, Dimension],
) -> Dimension | None:
    """Dimension of a sum, that of its body; or of a root, that of its interval."""
    if function == "sum":
        for end in ends:
            _plain(node, end, known, "a bound of sum")
        return dimension(body, {**known, variable: DIMENSIONLESS})
    interval = _same(node, ends, known, "both bounds of root") or DIMENSIONLESS
    dimension(body, {**known, variable: interval})
    return interval
