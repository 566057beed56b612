"""Numbers as Fortran reads them."""

import re

INTEGER = re.compile(r"[+-]?[0-9]+")
REAL = re.compile(r"([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))(?:[eEdD]([+-]?[0-9]+)|([+-][0-9]+))?")
LARGEST = 2**63 - 1  # integers are kept in 64 bits


def to_real(text: str) -> float:
    """The real number that `text` writes; the exponent's letter may be E, D or missing.

    Raises ValueError where `text` is not a number or too large for double precision.

    >>> [to_real(text) for text in ("1.", ".5", "1e5", "1.0d3", "1.0+5", "-1.5-3")]
    [1.0, 0.5, 100000.0, 1000.0, 100000.0, -0.0015]
    """
    match = REAL.fullmatch(text)
    if match is None:
        raise ValueError("not a number")
    mantissa, lettered, bare = match.groups()
    value = float(f"{mantissa}e{lettered or bare or 0}")
    if abs(value) == float("inf"):
        raise ValueError("too large for double precision")
    return value


def to_integer(text: str) -> int:
    """The integer that `text` writes; a real without a fraction will do.

    Raises ValueError where `text` is not an integer, or needs more than 64 bits.

    >>> [to_integer(text) for text in ("12", "-3", "3.", "1.0e3")]
    [12, -3, 3, 1000]
    """
    if INTEGER.fullmatch(text):
        value = int(text)
    else:
        real = to_real(text)
        if not real.is_integer():
            raise ValueError("not an integer")
        value = int(real)
    if abs(value) > LARGEST:
        raise ValueError("too large for an integer")
    return value
