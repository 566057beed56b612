"""Degrees of freedom by the DOF number of loads and prescribed motions."""

from vmharness.deck import Entry

CODES = ("", "x", "y", "z", "xy", "yz", "zx", "xyz")


def place(entry: Entry) -> int:
    """The entry's DOF as a column of (n, 6) arrays: x, y, z and the rotations about them."""
    return int(entry.dof - 1 if entry.dof < 4 else entry.dof - 2)


def coded(code: int) -> list[int]:
    """The axes of a constraint code, as TC and RC of *NODE have it: none, x, y, z, xy, yz, zx, xyz.

    >>> coded(6)
    [2, 0]
    """
    return ["xyz".index(axis) for axis in CODES[code]]
