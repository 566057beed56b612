"""Points in ranges of data: Latin hypercube and grid; equal seeds give equal points."""

import itertools
from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from vmharness.round_off import rounded

Range = tuple[float, float]
Point = dict[str, float]

DECADE = 10.0  # a positive range that spans this factor is sampled in its logarithm
DIGITS = 4  # significant digits of a sampled datum, so that it can be typed


def latin_hypercube(ranges: Mapping[str, Range], count: int, generator: np.random.Generator) -> list[Point]:
    """`count` points: each datum has one value in each of `count` equal parts of its range.

    (M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979), pp. 239-245.)
    """
    columns: dict[str, NDArray[np.float64]] = {}
    for name in ranges:
        columns[name] = (generator.permutation(count) + generator.random(count)) / count
    return [{name: within(ranges[name], float(columns[name][i])) for name in ranges} for i in range(count)]


def grid(ranges: Mapping[str, Range], count: int) -> list[Point]:
    """All points with each datum at one of `count` equally spaced values, both ends of its range included."""
    places = np.linspace(0.0, 1.0, count)
    lines = [[within(ends, float(place)) for place in places] for ends in ranges.values()]
    return [dict(zip(ranges, values, strict=True)) for values in itertools.product(*lines)]


def sampled(
    ranges: Mapping[str, Range], count: int, seed: int, accepted: Callable[[Point], bool]
) -> list[Point]:
    """Up to `count` accepted points, from one hypercube after the other, twenty at most."""
    return list(itertools.islice(_accepted(ranges, count, seed, accepted), count))


def _accepted(
    ranges: Mapping[str, Range], count: int, seed: int, accepted: Callable[[Point], bool]
) -> Iterator[Point]:
    generator = np.random.Generator(np.random.PCG64(seed))
    for _ in range(20):
        yield from filter(accepted, latin_hypercube(ranges, count, generator))


def within(ends: Range, place: float) -> float:
    """The value at `place` (0 to 1) of a range, rounded to DIGITS digits, within its ends.

    >>> within((0.0, 3.0), 0.5), within((1.0, 1e4), 0.5), within((2.0, 3.0), 1.0)
    (1.5, 100.0, 3.0)
    """
    low, high = ends
    if is_logarithmic(ends):
        value = low * (high / low) ** place
    else:
        value = low + (high - low) * place
    return min(max(rounded(value, DIGITS), low), high)


def is_logarithmic(ends: Range) -> bool:
    """Whether a range is sampled in its logarithm."""
    low, high = ends
    return low > 0.0 and high >= DECADE * low
