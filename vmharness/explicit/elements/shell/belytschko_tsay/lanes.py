"""Vectors at the four nodes in the buffer of explicit/kernels/simd.py."""

from vmharness.explicit.elements.shell.belytschko_tsay.frame import Corners
from vmharness.explicit.kernels.simd import put, vector
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.state import Array


@inlined
def corners(work: Array, row: int, e: int) -> Corners:
    """The vectors at the four nodes of element e."""
    return vector(work, row, e), vector(work, row + 3, e), vector(work, row + 6, e), vector(work, row + 9, e)


@inlined
def put_corners(work: Array, row: int, e: int, a: Corners) -> None:
    """Store the vectors at the four nodes of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
    put(work, row + 9, e, a[3])
