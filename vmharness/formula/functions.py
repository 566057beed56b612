"""The functions that a formula may call."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Function:
    """Arguments, numpy function and domain of a function."""

    arguments: str
    numpy: str = ""
    domain: str = ""

    @property
    def count(self) -> int:
        """The number of arguments, or the smallest number if more are allowed."""
        return self.arguments.replace(", ...", "").count(",") + 1

    def accepts(self, count: int) -> bool:
        """Whether the function accepts this number of arguments."""
        return count == self.count or (count > self.count and self.arguments.endswith("..."))


FUNCTIONS = {
    "sqrt": Function("x", "sqrt", "x >= 0"),
    "cbrt": Function("x", "cbrt"),
    "exp": Function("x", "exp"),
    "log": Function("x", "log", "x > 0"),
    "log10": Function("x", "log10", "x > 0"),
    "sin": Function("x", "sin"),
    "cos": Function("x", "cos"),
    "tan": Function("x", "tan"),
    "asin": Function("x", "arcsin", "-1 <= x <= 1"),
    "acos": Function("x", "arccos", "-1 <= x <= 1"),
    "atan": Function("x", "arctan"),
    "atan2": Function("y, x", "arctan2"),
    "sinh": Function("x", "sinh"),
    "cosh": Function("x", "cosh"),
    "tanh": Function("x", "tanh"),
    "abs": Function("x", "abs"),
    "sign": Function("x", "sign"),
    "min": Function("a, b, ...", "minimum"),
    "max": Function("a, b, ...", "maximum"),
    "ellipk": Function("m", "", "m < 1"),
    "besselj": Function("n, x", "", "x >= 0, or n whole"),
    "where": Function("condition, a, b"),
    "sum": Function("expression, n, first, last"),
    "root": Function("expression, x, low, high"),
}
