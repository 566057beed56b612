"""DOF, as loads and prescribed motions number degrees of freedom."""

from vmharness.deck.field import integer

DOF = integer(choices=(1, 2, 3, 5, 6, 7))  # along x, y, z; about x, y, z
