"""Text of a formula from its tree, with the fewest parentheses."""

from vmharness.formula.tree import Binary, Bound, Call, Comparison, Logic, Name, Negative, Node, Number

OR, AND, NOT, COMPARE, SUM, PRODUCT, POWER, ATOM = range(8)
LEVELS = {"or": OR, "and": AND, "not": NOT, "+": SUM, "-": SUM, "*": PRODUCT, "/": PRODUCT, "**": POWER}


def level(node: Node) -> int:
    """Precedence of the outermost operator of the node."""
    match node:
        case Binary(operator) | Logic(operator):
            return LEVELS[operator]
        case Comparison():
            return COMPARE
        case Negative():
            return SUM
        case _:
            return ATOM


def write(node: Node) -> str:
    """The text that is parsed to this very tree.

    >>> write(Binary("*", Name("a"), Binary("-", Name("b"), Negative(Name("c")))))
    'a*(b - (-c))'
    """
    match node:
        case Number(text) | Name(text):
            return text
        case Negative(operand):
            return "-" + _inside(operand, PRODUCT)
        case Binary("**", base, exponent):
            return f"{_inside(base, ATOM)}**{_inside(exponent, POWER)}"
        case Binary(operator, left, right):
            spaced = f" {operator} " if level(node) == SUM else operator
            return _inside(left, level(node)) + spaced + _inside(right, level(node) + 1)
        case Comparison(operators, (first, *others)):
            pairs = zip(operators, others, strict=True)
            return _inside(first, SUM) + "".join(f" {sign} {_inside(other, SUM)}" for sign, other in pairs)
        case Logic("not", (operand,)):
            return "not " + _inside(operand, NOT)
        case Logic(word, operands):
            return f" {word} ".join(_inside(operand, level(node) + 1) for operand in operands)
        case Call(function, arguments):
            return f"{function}({', '.join(map(write, arguments))})"
        case Bound(function, body, variable, low, high):
            return f"{function}({write(body)}, {variable}, {write(low)}, {write(high)})"
    raise AssertionError(node)


def _inside(node: Node, least: int) -> str:
    """The text of an operand, in parentheses if its precedence is below `least`."""
    text = write(node)
    return f"({text})" if level(node) < least else text
