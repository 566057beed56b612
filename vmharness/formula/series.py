"""The sum of a series."""

from dataclasses import replace

import numpy as np

from vmharness.formula.scope import Branch, Scope, Value

MAX_TERMS, MAX_EVALUATIONS, CHUNK = 10**6, 10**7, 10**6


def series(term: Branch, variable: str, first: Value, last: Value, scope: Scope) -> Value:
    """sum_{n=first}^{last} term(n) at every point; 0 if last < first; ValueError if there are too many terms.

    All terms of a chunk are evaluated at once, over points x terms, so that memory stays bounded.
    """
    start, stop = _whole(first), _whole(last) + 1
    points, terms = scope.points if scope.points is not None else 1, max(0, stop - start)
    if terms > MAX_TERMS or terms * points * scope.repeats > MAX_EVALUATIONS:
        raise ValueError(f"{terms} terms at {points * scope.repeats} points are too many")
    scope.work.add(terms * points * (1 + sum(value.ndim for value in scope.values.values())))
    step = max(1, CHUNK // max(1, points))
    repeats = scope.repeats * -(-terms // step)
    total = np.zeros(points)
    for at in range(start, stop, step):
        n = np.arange(at, min(at + step, stop), dtype=float)
        values = {
            name: np.repeat(value, n.size) if value.ndim else value for name, value in scope.values.items()
        }
        values[variable] = np.tile(n, points)
        found = np.broadcast_to(term(replace(scope, values=values, repeats=repeats)), (points * n.size,))
        total += found.reshape(points, n.size).sum(axis=1)
    return total if scope.points is not None else total[0]


def _whole(value: Value) -> int:
    """A bound: one whole number, the same at all points."""
    if np.size(value) == 0:
        return 0
    number = float(np.ravel(value)[0])
    if np.any(value != number) or not number.is_integer():
        raise ValueError(f"a bound is {number:g}: one whole number is expected, the same at all points")
    return int(number)
