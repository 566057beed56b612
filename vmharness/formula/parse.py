"""Parser: text of a formula to its tree, by recursive descent.

    condition   = conjunction {"or" conjunction}
    conjunction = negation {"and" negation}
    negation    = "not" negation | comparison
    comparison  = sum {("<" | "<=" | ">" | ">=" | "==" | "!=") sum}
    sum         = ["-"] product {("+" | "-") product}
    product     = factor {("*" | "/") factor}
    factor      = ("-" | "+") factor | atom ["**" factor]
    atom        = number | name | name "(" condition {"," condition} ")" | "(" condition ")"

Values are as in Python: -a**2 = -(a**2), a**b**c = a**(b**c), -a*b = (-a)*b.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from vmharness.formula.error import FormulaError, suggestion
from vmharness.formula.functions import FUNCTIONS
from vmharness.formula.text import write
from vmharness.formula.token import error, tokens
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

MAX_NESTING = 40  # with the bound on tokens it bounds the depth of the tree, so every recursion over it
COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")


def parse(text: str) -> Node:
    """The tree of a formula whose value is a number; raises FormulaError with the column of an error.

    >>> parse("2*h")
    Binary(operator='*', left=Number(text='2'), right=Name(name='h'))
    """
    parser = _Parser(text)
    tree = parser.condition()
    if parser.token.kind != "end":
        raise parser.expected("an operator")
    _require(tree, tree, condition=False)
    return tree


def _require(node: Node, parent: Node, condition: bool) -> None:
    """Check that conditions and numbers are where they belong."""
    if isinstance(node, Comparison | Logic) != condition:
        what = "a condition such as a < b" if condition else "a number"
        raise FormulaError(f"in `{write(parent)}`: {what} is expected, not `{write(node)}`")
    match node:
        case Logic():
            for operand in node.operands:
                _require(operand, node, condition=True)
        case Bound():
            for part in (node.body, node.low, node.high):
                _require(part, node, condition=False)
        case Call("where", (choice, *branches)):
            _require(choice, node, condition=True)
            for branch in branches:
                _require(branch, node, condition=False)
        case Binary() | Negative() | Call() | Comparison():
            for operand in children(node):
                _require(operand, node, condition=False)


class _Parser:
    """The grammar: one method for each rule, which leaves `token` at the first token after the rule."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.rest = iter(tokens(text))
        self.token = next(self.rest)
        self.nesting = 0

    def expected(self, what: str) -> FormulaError:
        """The error at the present token."""
        found = f"`{self.token.text}`" if self.token.text else "the end"
        return error(self.text, self.token.column, f"{what} is expected, not {found}")

    def take(self, *words: str) -> str:
        """Step over the token if it is one of `words` and return it, else return ""."""
        word = self.token.text
        if word not in words:
            return ""
        self.token = next(self.rest)
        return word

    def need(self, sign: str) -> None:
        """Step over `sign`."""
        if not self.take(sign):
            raise self.expected(f"an operator or `{sign}`")

    @contextmanager
    def nested(self) -> Iterator[None]:
        """One level deeper."""
        self.nesting += 1
        if self.nesting > MAX_NESTING:
            raise error(self.text, self.token.column, f"nested deeper than {MAX_NESTING}; name its parts")
        yield
        self.nesting -= 1

    def condition(self) -> Node:
        return self.joined("or", lambda: self.joined("and", self.negation))

    def joined(self, word: str, rule: Callable[[], Node]) -> Node:
        operands = [rule()]
        while self.take(word):
            operands.append(rule())
        return Logic(word, tuple(operands)) if len(operands) > 1 else operands[0]

    def negation(self) -> Node:
        if not self.take("not"):
            return self.comparison()
        with self.nested():
            return Logic("not", (self.negation(),))

    def comparison(self) -> Node:
        operators, operands = [], [self.sum()]
        while operator := self.take(*COMPARISONS):
            operators.append(operator)
            operands.append(self.sum())
        return Comparison(tuple(operators), tuple(operands)) if operators else operands[0]

    def sum(self) -> Node:
        # -a*b is read as -(a*b): the same number, and typeset as it is meant.
        left: Node = Negative(self.product()) if self.take("-") else self.product()
        while operator := self.take("+", "-"):
            left = Binary(operator, left, self.product())
        return left

    def product(self) -> Node:
        left = self.factor()
        while operator := self.take("*", "/"):
            left = Binary(operator, left, self.factor())
        return left

    def factor(self) -> Node:
        with self.nested():
            if self.take("-"):
                return Negative(self.factor())
            if self.take("+"):
                return self.factor()
            base = self.atom()
            return Binary("**", base, self.factor()) if self.take("**") else base

    def atom(self) -> Node:
        kind, word = self.token.kind, self.token.text
        if kind == "number":
            return self.number()
        if kind == "name" and word not in ("and", "or", "not"):
            return self.name()
        if not self.take("("):
            raise self.expected("a number, a name or `(`")
        inside = self.condition()
        self.need(")")
        return inside

    def number(self) -> Node:
        word, column = self.token.text, self.token.column
        if float(word) == float("inf"):
            raise self.expected("a number below 1.8e308")
        self.take(word)
        if self.token.kind == "name" and self.token.column == column + len(word):
            raise error(self.text, column, f"`{word}{self.token.text}`: write {word}*{self.token.text}")
        return Number(word)

    def name(self) -> Node:
        word, column = self.token.text, self.token.column
        self.take(word)
        called = bool(self.take("("))
        if called and word not in FUNCTIONS:
            hint = suggestion(word, FUNCTIONS)
            raise error(self.text, column, f"`{word}` is not a function; {hint}")
        if not called:
            if word in FUNCTIONS:
                raise error(self.text, column, f"`{word}` is a function: {word}({FUNCTIONS[word].arguments})")
            return Name(word)
        arguments = [self.condition()]
        while self.take(","):
            arguments.append(self.condition())
        self.need(")")
        if not FUNCTIONS[word].accepts(len(arguments)):
            raise error(
                self.text, column, f"{word} takes ({FUNCTIONS[word].arguments}), not {len(arguments)} of them"
            )
        return (
            self.bound(word, column, arguments) if word in ("sum", "root") else Call(word, tuple(arguments))
        )

    def bound(self, function: str, column: int, arguments: list[Node]) -> Node:
        body, variable, low, high = arguments
        if not isinstance(variable, Name) or variable.name == "pi":
            raise error(self.text, column, f"{function}: a name is expected second, not `{write(variable)}`")
        return Bound(function, body, variable.name, low, high)
