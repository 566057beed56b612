"""job.dat of CalculiX, read strictly: blocks of numbers, one for each quantity, set and step.

     displacements (vx,vy,vz) for set N7 and time  0.1000000E-03

             7  0.000000E+00 -1.930000-103  0.000000E+00

A Fortran exponent of three digits has no E. Stars, NaN, a block that is cut off, and steps that are missing are errors.
"""

import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Key = tuple[str, str]  # quantity, set

HEAD = re.compile(r" (?P<quantity>[a-z ]+?) ?(?:\(.*\))? ?for set (?P<set>\S+) and time +(?P<time>\S+)\s*")
NUMBER = re.compile(r"\d+|[+-]?\d\.\d{6,7}E[+-]\d\d")
NO_LETTER = re.compile(r"([+-]?\d\.\d{6,7})([+-]\d{3})")
SAME = 1e-6  # of the time: it has seven digits


class DatError(ValueError):
    """job.dat is not what CalculiX writes where all is well."""


def read(path: Path, times: Array) -> dict[Key, Array]:
    """The blocks (steps, rows, columns) of each quantity and set; the first `numbers` of each row are left out.

    `times` (steps,) are those of all steps. Raises DatError.
    """
    if not path.is_file():
        raise DatError(f"{path.name} was not written")
    blocks: dict[Key, list[Array]] = defaultdict(list)
    for key, time, rows in _blocks(path):
        step = len(blocks[key])
        if step >= times.size or abs(time - times[step]) > SAME * times[-1]:
            expected = f"{times[step]:g}" if step < times.size else "no more"
            raise DatError(f"{path.name}: {' of '.join(key)} at time {time:g}, expected {expected}")
        if blocks[key] and rows.shape != blocks[key][0].shape:
            raise DatError(f"{path.name}: {' of '.join(key)} at time {time:g} is cut off")
        blocks[key].append(rows)
    for key, found in blocks.items():
        if len(found) < times.size:
            reached = f"after {len(found)} of {times.size} steps"
            raise DatError(f"{path.name}: {' of '.join(key)} ends {reached}, before t = {times[-1]:g}")
    if not blocks:
        raise DatError(f"{path.name} is empty")
    return {key: np.array(found) for key, found in blocks.items()}


def _blocks(path: Path) -> Iterator[tuple[Key, float, Array]]:
    """Key, time and rows (rows, columns) of each block."""
    key: Key | None = None
    time, rows = 0.0, []
    with path.open(encoding="ascii", errors="replace") as lines:
        for number, line in enumerate(lines, 1):
            if not line.strip():
                continue
            place = f"{path.name}:{number}"
            head = HEAD.fullmatch(line)
            if head is None:
                if key is None:
                    raise DatError(f"{place}: no heading of a block: {line.strip()!r}")
                rows.append([_number(word, place) for word in line.split()])
                continue
            if key is not None:
                yield key, time, _array(key, rows, place)
            key, time, rows = (head["quantity"], head["set"]), _number(head["time"], place), []
    if key is not None:
        yield key, time, _array(key, rows, place)


def _array(key: Key, rows: list[list[float]], place: str) -> Array:
    if not rows or len({len(row) for row in rows}) > 1:
        raise DatError(f"{place}: {' of '.join(key)}: rows are missing, or cut off")
    return np.array(rows)


def _number(word: str, place: str) -> float:
    """A number as Fortran writes it; raises DatError for any other word.

    >>> _number("6.319000-103", ""), _number("-1.000000E-02", "")
    (6.319e-103, -0.01)
    """
    if NUMBER.fullmatch(word):
        return float(word)
    if match := NO_LETTER.fullmatch(word):
        return float(f"{match[1]}E{match[2]}")
    raise DatError(f"{place}: {word!r} is no number")
