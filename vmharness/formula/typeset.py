"""Typeset formula from its tree: fractions, parentheses, rows of cases."""

import re
from collections.abc import Mapping

from vmharness.formula.error import FormulaError
from vmharness.formula.notation import Notation
from vmharness.formula.symbol import symbol
from vmharness.formula.text import ATOM, COMPARE, NOT, POWER, PRODUCT, SUM, level
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
    substitute,
)

NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln", "sign": "sgn"}
_NUMBER = re.compile(r"([-−]?)((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)")


def typeset(node: Node, to: Notation) -> str:
    """The node in a notation."""
    match node:
        case Number(text):
            return _number(text, to)
        case Name(name):
            return to.name(symbol(name))
        case Negative(operand):
            return to.negative(_inside(operand, PRODUCT, to))
        case Binary():
            return _binary(node, to)
        case Comparison(signs, (first, *others)):
            pairs = [
                (to.sign(sign), _inside(other, SUM, to)) for sign, other in zip(signs, others, strict=True)
            ]
            return to.row(_inside(first, SUM, to), *(part for pair in pairs for part in pair))
        case Logic("not", (operand,)):
            return to.row(to.sign("not"), _inside(operand, NOT, to))
        case Logic(word, (first, *rest)):
            least = level(node) + 1
            more = [part for other in rest for part in (to.sign(word), _inside(other, least, to))]
            return to.row(_inside(first, least, to), *more)
        case Call("where"):
            return to.cases(_branches(node, to))
        case Call(function, arguments):
            return _call(function, arguments, to)
        case Bound():
            return _bound(node, to)
    raise AssertionError(node)


def terms(node: Node, to: Notation) -> list[str]:
    """The terms of a sum, each after the first with its sign in front; together they are the typeset node."""
    match node:
        case Binary("+" | "-" as operator, left, right):
            before = terms(left, to) if _level(left) == SUM else [_inside(left, SUM, to)]
            return [*before, to.row(to.infix(operator), _inside(right, PRODUCT, to))]
    return [typeset(node, to)]


def replaced(node: Node, values: Mapping[str, str] | None, symbols: Mapping[str, str] | None) -> Node:
    """The tree with names replaced: by the numbers of `values` (texts), by the names of `symbols`."""
    new: dict[str, Node] = {name: Name(other) for name, other in (symbols or {}).items()}
    for name, text in (values or {}).items():
        new[name] = number(text)
    return substitute(node, new)


def number(text: str) -> Node:
    """The node of a signed number."""
    found = _NUMBER.fullmatch(text.strip())
    if not found:
        raise FormulaError(f"`{text}` is not a number")
    return Negative(Number(found[2])) if found[1] else Number(found[2])


def _number(text: str, to: Notation) -> str:
    """1.5e-3 as 1.5 x 10^-3."""
    digits, _, exponent = text.lower().partition("e")
    if not exponent:
        return to.number(digits)
    tens = typeset(Binary("**", Number("10"), number(exponent.lstrip("+"))), to)
    return tens if digits == "1" else to.row(to.number(digits), to.sign("·"), tens)


def _level(node: Node) -> int:
    """Precedence of the typeset node, which differs from that of its text for fractions and powers."""
    match node:
        case Number(text) if "e" in text.lower():
            return POWER if text.lower().startswith("1e") else PRODUCT
        case Call("exp" | "sqrt" | "cbrt", _):
            return POWER
        case Call("where", _):
            return COMPARE
        case Bound("sum"):
            return PRODUCT
        case _:
            return level(node)


def _inside(node: Node, least: int, to: Notation) -> str:
    """An operand, in parentheses if its precedence is below `least`."""
    text = typeset(node, to)
    return to.fenced(text) if _level(node) < least else text


def _binary(node: Binary, to: Notation) -> str:
    left, right = node.left, node.right
    match node.operator:
        case "/":
            return to.fraction(typeset(left, to), typeset(right, to))
        case "**":
            return _power(left, right, to)
        case "*":
            between = "·" if _meets_digit(left, right) else "times"
            return to.row(_inside(left, PRODUCT, to), to.sign(between), _inside(right, PRODUCT, to))
    return to.row(_inside(left, SUM, to), to.sign(node.operator), _inside(right, PRODUCT, to))


def _meets_digit(left: Node, right: Node) -> bool:
    """Whether the factors would read as one number, or as a mixed fraction, without a dot between."""
    match right:
        case Number():
            return True
        case Binary("*" | "**", first, _):
            return _meets_digit(left, first)
        case Binary("/", _, _):
            return isinstance(left, Number)
        case _:
            return False


def _power(base: Node, exponent: Node, to: Notation) -> str:
    """A power; sin(x)**2 as sin^2(x)."""
    match base, exponent:
        case Call(function, arguments), Number() if function in ("sin", "cos", "tan", "sinh", "cosh", "tanh"):
            raised = to.power(to.function(function), typeset(exponent, to))
            return to.row(raised, to.fenced(typeset(arguments[0], to)))
    return to.power(_inside(base, ATOM, to), typeset(exponent, to))


def _call(function: str, arguments: tuple[Node, ...], to: Notation) -> str:
    parts = [typeset(argument, to) for argument in arguments]
    match function:
        case "sqrt":
            return to.radical(parts[0])
        case "cbrt":
            return to.radical(parts[0], to.number("3"))
        case "abs":
            return to.fenced(parts[0], "||")
        case "exp":
            return to.power(to.upright("e"), parts[0])
        case "log10":
            return to.row(to.subscript(to.function("log"), to.number("10")), to.fenced(parts[0]))
        case "ellipk":
            return to.row(to.name(symbol("K")), to.fenced(parts[0]))
        case "besselj":
            return to.row(to.subscript(to.name(symbol("J")), parts[0]), to.fenced(parts[1]))
    listed = [part for other in parts[1:] for part in (to.sign(","), other)]
    return to.row(to.function(NAMES.get(function, function)), to.fenced(to.row(parts[0], *listed)))


def _branches(node: Node, to: Notation) -> list[tuple[str, str]]:
    """Rows (value, condition) of a `where`; a nested `where` in the last branch adds its rows."""
    match node:
        case Call("where", (condition, value, other)):
            return [(typeset(value, to), to.when(typeset(condition, to))), *_branches(other, to)]
        case _:
            return [(typeset(node, to), to.upright("otherwise"))]


def _bound(node: Bound, to: Notation) -> str:
    variable, low, high = to.name(symbol(node.variable)), typeset(node.low, to), typeset(node.high, to)
    if node.function == "sum":
        below = to.row(variable, to.sign("=="), low)
        return to.row(to.summation(below, high), _inside(node.body, PRODUCT, to))
    interval = to.fenced(to.row(low, to.sign(","), high), "[]")
    equation = to.row(typeset(node.body, to), to.sign("=="), to.number("0"))
    return to.fenced(to.row(variable, to.sign("in"), interval, to.sign(":"), equation), "{}")
