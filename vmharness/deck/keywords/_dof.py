"""DOF, as loads and prescribed motions number degrees of freedom."""

from vmharness.deck.field import integer

DOF = integer()  # along x, y, z; about x, y, z
