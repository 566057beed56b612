"""Arithmetic of *PARAMETER_EXPRESSION: parsed against a whitelist, never run as Python."""

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Any

Number = int | float

LONGEST = 500  # characters; keeps nesting within the parser's depth
LARGEST = 2**63 - 1
SYMBOLS = re.compile(r"[0-9e.+\-*/(), ]*")  # of what is no name: no hexadecimal numbers, strings, ...
NAME = re.compile(r"&?(?<![\w.])([a-z_]\w*)")


def divide(a: Number, b: Number) -> Number:
    """a / b; two integers must divide without rest, for Fortran would drop it."""
    if isinstance(a, int) and isinstance(b, int):
        if a % b:
            raise ValueError(f"{a}/{b} is a division of integers with a rest; write {a}.0/{b}")
        return a // b
    return a / b


def power(a: Number, b: Number) -> Number:
    """a**b; an integer to a negative integer is refused, for Fortran would drop the fraction."""
    if isinstance(a, int) and isinstance(b, int):
        if b < 0:
            raise ValueError(f"{a}**({b}) is an integer to a negative power; write {a}.0")
        if b * a.bit_length() > 64:
            raise OverflowError
    return a**b


def mod(a: Number, b: Number) -> Number:
    """a - int(a/b) b: the sign is a's."""
    result = math.fmod(a, b)
    return int(result) if isinstance(a, int) and isinstance(b, int) else result


OPERATORS: dict[type, Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: divide,
    ast.Pow: power,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}
PLAIN = (
    *(math.acos, math.asin, math.atan, math.atan2, math.ceil, math.cos, math.cosh, math.exp, math.floor),
    *(math.log, math.log10, math.sin, math.sinh, math.sqrt, math.tan, math.tanh),
)
FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{function.__name__: function for function in PLAIN},
    "abs": abs,
    "float": float,
    "int": int,
    "max": max,
    "min": min,
    "mod": mod,
    "nint": lambda a: int(math.copysign(math.floor(abs(a) + 0.5), a)),
    "sign": lambda a, b: math.copysign(abs(a), b) if isinstance(a, float) else abs(a) * (-1 if b < 0 else 1),
}


def evaluate(text: str, names: Mapping[str, Number | str]) -> Number:
    """The value of an expression over parameters (with or without &): + - * / ** () and `FUNCTIONS`.

    Integers stay integers, as in Fortran, but a division of integers that would lose its rest is refused.
    Raises ValueError saying what is wrong.

    >>> evaluate("sqrt(&side**2 + 16)/1.0d1", {"side": 3.0})
    0.5
    """
    if len(text) > LONGEST:
        raise ValueError(f"the expression has more than {LONGEST} characters")
    source = re.sub(r"(?<=[0-9.])d(?=[+-]?[0-9])", "e", text.strip().lower())
    try:
        if not SYMBOLS.fullmatch(NAME.sub("", source)):
            raise SyntaxError
        # "_" before each name: a parameter may have the name of a word of Python
        tree = ast.parse(NAME.sub(r"_\1", source), mode="eval")
        return _value(tree.body, names)
    except (SyntaxError, RecursionError, MemoryError):
        raise ValueError("not an expression of numbers, parameters, + - * / ** ( ) and functions") from None
    except ZeroDivisionError:
        raise ValueError("division by zero") from None
    except OverflowError:
        raise ValueError("a value is too large") from None
    except TypeError:
        raise ValueError("a function has the wrong number of arguments") from None


def _value(node: ast.expr, names: Mapping[str, Number | str]) -> Number:
    result: Any
    match node:
        case ast.Constant(value=int() | float() as result) if not isinstance(result, bool):
            pass
        case ast.Name(id=name):
            result = names.get(name[1:])
            if not isinstance(result, (int, float)):
                raise ValueError(_unknown("parameter", name[1:], names))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATORS:
            result = OPERATORS[type(op)](_value(operand, names))
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            result = OPERATORS[type(op)](_value(left, names), _value(right, names))
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
            if name[1:] not in FUNCTIONS:
                raise ValueError(_unknown("function", name[1:], FUNCTIONS))
            result = FUNCTIONS[name[1:]](*(_value(arg, names) for arg in args))
        case _:
            raise SyntaxError
    if isinstance(result, complex) or not math.isfinite(result):
        raise ValueError("not a finite real number")
    if isinstance(result, int) and abs(result) > LARGEST:
        raise OverflowError
    return result


def _unknown(kind: str, name: str, known: Mapping[str, object]) -> str:
    near = get_close_matches(name, known, n=1)
    return f"{name}: no such {kind}" + (f"; did you mean {near[0]}?" if near else "")
