"""A formula: text that is parsed once, then checked, evaluated and typeset."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from vmharness.formula import latex, mathml
from vmharness.formula.check import dimension
from vmharness.formula.dimension import DIMENSIONLESS, Dimension
from vmharness.formula.parse import parse
from vmharness.formula.tree import Node, names
from vmharness.formula.typeset import replaced, typeset


@dataclass(frozen=True)
class Formula:
    """A formula over named quantities, in consistent units; raises FormulaError.

    >>> f = Formula("sqrt(2*h/g)")
    >>> sorted(f.names), round(f.evaluate({"h": 1.0, "g": 386.0}), 7)
    (['g', 'h'], 0.0719816)
    """

    text: str
    tree: Node = field(init=False, repr=False, compare=False)
    names: frozenset[str] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "tree", parse(self.text))
        object.__setattr__(self, "names", names(self.tree))

    def dimension(self, known: Mapping[str, Dimension]) -> Dimension:
        """The dimension, with units checked through every operation; a zero alone is dimensionless."""
        return dimension(self.tree, known) or DIMENSIONLESS

    def evaluate(self, values: Mapping[str, Any]) -> Any:
        """A float, or an array of the common shape of the arrays among `values`; never infinite or NaN."""
        from vmharness.formula.evaluate import evaluate  # numpy is imported only when it is needed

        return evaluate(self.tree, values)

    def latex(self, values: Mapping[str, str] | None = None, symbols: Mapping[str, str] | None = None) -> str:
        r"""LaTeX without its dollars; `values` puts numbers, `symbols` other names in the places of names.

        >>> print(Formula("2*v0/omega").latex(), Formula("2*h").latex(values={"h": "1e-3"}), sep=", ")
        \frac{2 \thinspace v_{0}}{\omega}, 2 \cdot 10^{-3}
        """
        return typeset(replaced(self.tree, values, symbols), latex)

    def mathml(
        self, values: Mapping[str, str] | None = None, symbols: Mapping[str, str] | None = None
    ) -> str:
        """The content of a <math> element; `values` and `symbols` as for `latex`."""
        return typeset(replaced(self.tree, values, symbols), mathml)
