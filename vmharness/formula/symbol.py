"""A name taken apart for typesetting: `t_impact` is t with subscript "impact", `v0` is v with subscript 0."""

import re
from dataclasses import dataclass

GREEK = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "epsilon": "ε",
    "zeta": "ζ",
    "eta": "η",
    "theta": "θ",
    "iota": "ι",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "xi": "ξ",
    "pi": "π",
    "rho": "ρ",
    "sigma": "σ",
    "tau": "τ",
    "upsilon": "υ",
    "phi": "φ",
    "chi": "χ",
    "psi": "ψ",
    "omega": "ω",
    "Gamma": "Γ",
    "Delta": "Δ",
    "Theta": "Θ",
    "Lambda": "Λ",
    "Xi": "Ξ",
    "Pi": "Π",
    "Sigma": "Σ",
    "Phi": "Φ",
    "Psi": "Ψ",
    "Omega": "Ω",
}
ACCENTS = ("dot", "ddot", "bar")


@dataclass(frozen=True)
class Symbol:
    """A letter or word, its subscripts, and an accent ("" for none)."""

    base: str
    subscripts: tuple[str, ...]
    accent: str


def symbol(name: str) -> Symbol:
    """The parts of a name.

    >>> symbol("x1_dot")
    Symbol(base='x', subscripts=('1',), accent='dot')
    >>> symbol("sigma_y_max")
    Symbol(base='sigma', subscripts=('y', 'max'), accent='')
    """
    first, *subscripts = [part for part in name.split("_") if part]
    accent = subscripts.pop() if subscripts and subscripts[-1] in ACCENTS else ""
    numbered = re.fullmatch(r"([A-Za-z]+)(\d+)", first)
    if numbered:
        first, subscripts = numbered[1], [numbered[2], *subscripts]
    return Symbol(first, tuple(subscripts), accent)
