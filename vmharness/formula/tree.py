"""A formula as a tree: numbers, names, operations, calls."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeAlias


@dataclass(frozen=True)
class Number:
    """A number, as written: `2`, `0.5`, `1e-3`."""

    text: str


@dataclass(frozen=True)
class Name:
    """A given or derived quantity, a bound variable, or `pi`."""

    name: str


@dataclass(frozen=True)
class Negative:
    """-operand."""

    operand: "Node"


@dataclass(frozen=True)
class Binary:
    """left operator right, with one of + - * / **."""

    operator: str
    left: "Node"
    right: "Node"


@dataclass(frozen=True)
class Comparison:
    """A chain such as a < b <= c, with one operand more than operators."""

    operators: tuple[str, ...]
    operands: tuple["Node", ...]


@dataclass(frozen=True)
class Logic:
    """Conditions joined by `and` or `or`, or one under `not`."""

    operator: str
    operands: tuple["Node", ...]


@dataclass(frozen=True)
class Call:
    """function(arguments), `where(condition, a, b)` among them."""

    function: str
    arguments: tuple["Node", ...]


@dataclass(frozen=True)
class Bound:
    """sum or root (body, variable, low, high): `variable` is known in `body` alone."""

    function: str
    body: "Node"
    variable: str
    low: "Node"
    high: "Node"


Node: TypeAlias = Number | Name | Negative | Binary | Comparison | Logic | Call | Bound


def names(node: Node) -> frozenset[str]:
    """Free names: bound variables and `pi` are not among them."""
    match node:
        case Number():
            return frozenset()
        case Name(name):
            return frozenset({name} - {"pi"})
        case Bound(_, body, variable, low, high):
            return (names(body) - {variable}) | names(low) | names(high)
        case _:
            return frozenset().union(*map(names, children(node)))


def children(node: Negative | Binary | Comparison | Logic | Call) -> tuple[Node, ...]:
    """The operands of a node that binds no variable."""
    match node:
        case Negative(operand):
            return (operand,)
        case Binary(_, left, right):
            return left, right
        case Comparison(_, operands) | Logic(_, operands):
            return operands
        case Call(_, arguments):
            return arguments


def substitute(node: Node, replacement: Mapping[str, Node]) -> Node:
    """The tree with free names replaced."""
    match node:
        case Number():
            return node
        case Name(name):
            return replacement.get(name, node)
        case Bound(function, body, variable, low, high):
            inner = {name: new for name, new in replacement.items() if name != variable}
            low, high = substitute(low, replacement), substitute(high, replacement)
            return Bound(function, substitute(body, inner), variable, low, high)
    new = tuple(substitute(child, replacement) for child in children(node))
    match node:
        case Negative():
            return Negative(*new)
        case Binary(operator, _, _):
            return Binary(operator, *new)
        case Comparison(operators, _):
            return Comparison(operators, new)
        case Logic(operator, _):
            return Logic(operator, new)
        case Call(function, _):
            return Call(function, new)
