"""The value of a formula, on numbers or on numpy arrays."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import reduce
from typing import Any

import numpy as np

from vmharness.formula.bisection import STEPS, bisection
from vmharness.formula.error import FormulaError, suggestion
from vmharness.formula.functions import FUNCTIONS
from vmharness.formula.scope import CALL, Scope, Value, choose
from vmharness.formula.series import MAX_EVALUATIONS, series
from vmharness.formula.text import write
from vmharness.formula.tree import Binary, Bound, Call, Comparison, Logic, Name, Negative, Node, Number, names

COMPARE = {
    "<": np.less,
    "<=": np.less_equal,
    ">": np.greater,
    ">=": np.greater_equal,
    "==": np.equal,
    "!=": np.not_equal,
}
SLOW = ("besselj", "ellipk")  # each number takes as long as a call


def evaluate(tree: Node, given: Mapping[str, Any]) -> Any:
    """Value in consistent units: a float, or an array of the common shape of the arrays given.

    Every operation must give a finite number, or FormulaError names it; it also ends an evaluation that would take
    more than some seconds. A branch of `where` is evaluated only at the points where it is taken.
    """
    needed = sorted(names(tree))
    for name in needed:
        if name not in given:
            raise FormulaError(f"`{name}` has no value; {suggestion(name, given)}")
    values = {name: np.asarray(given[name], dtype=float) for name in needed}
    for name, value in values.items():
        if not np.isfinite(value).all():
            raise FormulaError(f"`{name}` has a value that is not finite")
    try:
        shape = np.broadcast_shapes(*(value.shape for value in values.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {value.shape}" for name, value in values.items() if value.ndim)
        raise FormulaError(f"arrays of shapes that do not go together: {shapes}") from None
    points = {
        name: np.broadcast_to(value, shape).ravel() if value.ndim else value[()]
        for name, value in values.items()
    }
    with np.errstate(all="ignore"):
        result = _value(tree, Scope(points))
    if not shape:
        return float(result)
    return np.array(np.broadcast_to(result, int(np.prod(shape)))).reshape(shape)


def _value(node: Node, scope: Scope) -> Value:
    scope.work.add(scope.points or 1)
    match node:
        case Number(text):
            return np.float64(text)
        case Name("pi"):
            return np.float64(np.pi)
        case Name(name):
            return scope.values[name]
        case Negative(operand):
            return -_value(operand, scope)
        case Binary(operator, left, right):
            return _binary(node, operator, _value(left, scope), _value(right, scope))
        case Call("where", (condition, then, other)):
            return choose(
                _truth(condition, scope), scope, lambda s: _value(then, s), lambda s: _value(other, s)
            )
        case Call(function, arguments):
            if function in SLOW:
                scope.work.add(CALL * (scope.points or 1))
            return _call(node, function, [_value(argument, scope) for argument in arguments])
        case Bound("sum"):
            return _series(node, scope)
        case Bound():
            return _root(node, scope)
        case _:
            raise AssertionError(node)


def _finite(node: Node, value: Value, why: Callable[[], str]) -> Value:
    """`value` if it is finite everywhere; the operands were finite, so otherwise this operation is the cause."""
    if not np.isfinite(value).all():
        raise FormulaError(f"in `{write(node)}`: {why()}")
    return value


def _binary(node: Node, operator: str, a: Value, b: Value) -> Value:
    match operator:
        case "+":
            return _finite(node, a + b, lambda: "overflow")
        case "-":
            return _finite(node, a - b, lambda: "overflow")
        case "*":
            return _finite(node, a * b, lambda: "overflow")
        case "/":
            return _finite(
                node, np.divide(a, b), lambda: "division by zero" if np.any(b == 0) else "overflow"
            )
    return _finite(node, np.power(a, b), lambda: _power_fault(a, b))


def _power_fault(base: Value, exponent: Value) -> str:
    if np.any((base == 0) & (exponent < 0)):
        return "division by zero"
    if np.any((base < 0) & (exponent != np.floor(exponent))):
        return "a negative number to a fractional power"
    return "overflow"


def _call(node: Node, function: str, arguments: list[Value]) -> Value:
    value = reduce(_ufunc(function), arguments) if len(arguments) > 2 else _ufunc(function)(*arguments)
    domain = FUNCTIONS[function].domain

    def why() -> str:
        if not domain:
            return "overflow"
        x = np.broadcast_to(arguments[-1], np.shape(value)).ravel()[np.argmin(np.isfinite(np.ravel(value)))]
        return f"{function}({FUNCTIONS[function].arguments}) needs {domain}, and gets {float(x):g}"

    return _finite(node, value, why)


def _ufunc(function: str) -> Callable[..., Value]:
    if function in SLOW:
        from scipy import special

        return special.ellipk if function == "ellipk" else special.jv
    return getattr(np, FUNCTIONS[function].numpy)


def _truth(node: Node, scope: Scope) -> Value:
    """Whether a condition holds; the right side of `and`, `or` is evaluated only if the left does not decide."""
    match node:
        case Comparison(operators, operands):
            values = [_value(operand, scope) for operand in operands]
            pairs = zip(operators, values, values[1:], strict=False)
            return reduce(np.logical_and, [COMPARE[sign](a, b) for sign, a, b in pairs])
        case Logic("not", (operand,)):
            return np.logical_not(_truth(operand, scope))
        case Logic(word, (*left, right)):
            first = _truth(left[0] if len(left) == 1 else Logic(word, tuple(left)), scope)
            if word == "and":
                return choose(first, scope, lambda s: _truth(right, s), lambda s: np.False_)
            return choose(first, scope, lambda s: np.True_, lambda s: _truth(right, s))
        case _:
            raise AssertionError(node)


def _series(node: Bound, scope: Scope) -> Value:
    first, last = _value(node.low, scope), _value(node.high, scope)
    try:
        total = series(lambda s: _value(node.body, s), node.variable, first, last, scope)
    except ValueError as fault:
        raise FormulaError(f"in `{write(node)}`: {fault}") from None
    return _finite(node, total, lambda: "overflow")


def _root(node: Bound, scope: Scope) -> Value:
    shape = () if scope.points is None else (scope.points,)
    repeats = scope.repeats * STEPS

    def body(x: Value) -> Value:
        inner = replace(scope, values={**scope.values, node.variable: x}, repeats=repeats)
        return np.broadcast_to(_value(node.body, inner), shape)[()]

    low, high = (np.broadcast_to(_value(end, scope), shape)[()] for end in (node.low, node.high))
    try:
        if repeats * (scope.points or 1) > MAX_EVALUATIONS:
            raise ValueError("too many points")
        return bisection(body, low, high)
    except ValueError as fault:
        raise FormulaError(f"in `{write(node)}`: {fault}") from None
