"""The motion of eight nodes as eight patterns, which make the equations of a hexahedron short.

           8 ------ 7           xi    runs from face 1 4 8 5 to face 2 3 7 6
          /|       /|           eta   from 1 2 6 5 to 4 3 7 8
         5 ------ 6 |           zeta  from 1 2 3 4 to 5 6 7 8
         | 4 -----| 3
         |/       |/            x(xi, eta, zeta) = x_0 + xi x_1 + eta x_2 + zeta x_3
         1 ------ 2                 + eta zeta x_4 + zeta xi x_5 + xi eta x_6 + xi eta zeta x_7

x_k = 1/8 sum Lambda_kI x_I with the values Lambda_kI = +-1 of the pattern k at the nodes. Patterns 1 to 3 stretch and
rotate a cube; 4 to 7 are its hourglass modes. A force on pattern k, conjugate to v_k, is f_k = sum Lambda_kI f_I, and
the nodes have f_I = 1/8 sum Lambda_kI f_k. Pattern 0 is a translation: it has no strain and is left out.
"""

from vmharness.explicit.kernels.vector import Vector, add, inlined, scale, subtract

Nodes = tuple[Vector, Vector, Vector, Vector, Vector, Vector, Vector, Vector]
Patterns = tuple[Vector, Vector, Vector, Vector, Vector, Vector, Vector]


@inlined
def patterns(a: Nodes) -> Patterns:
    """x_1 to x_7 of the vectors at the nodes."""
    even = (add(a[0], a[1]), add(a[3], a[2]), add(a[4], a[5]), add(a[7], a[6]))
    odd = (subtract(a[1], a[0]), subtract(a[2], a[3]), subtract(a[5], a[4]), subtract(a[6], a[7]))
    e = _square(even)
    o = _square(odd)
    return o[0], e[1], e[2], e[3], o[2], o[1], o[3]


@inlined
def _square(a: tuple[Vector, Vector, Vector, Vector]) -> tuple[Vector, Vector, Vector, Vector]:
    """1/8 of a summed with signs 1, eta, zeta, eta zeta over (-, -), (+, -), (-, +), (+, +)."""
    near, far = add(a[0], a[1]), add(a[2], a[3])
    near_eta, far_eta = subtract(a[1], a[0]), subtract(a[3], a[2])
    return (
        scale(0.125, add(near, far)),
        scale(0.125, add(near_eta, far_eta)),
        scale(0.125, subtract(far, near)),
        scale(0.125, subtract(far_eta, near_eta)),
    )


@inlined
def nodal(f: Patterns) -> Nodes:
    """Nodal forces f_I = 1/8 sum Lambda_kI f_k of the forces f_1 to f_7 on the patterns."""
    zero = (0.0, 0.0, 0.0)
    even = _corners(zero, f[1], f[2], f[3])
    odd = _corners(f[0], f[5], f[4], f[6])
    return (
        subtract(even[0], odd[0]),
        add(even[0], odd[0]),
        add(even[1], odd[1]),
        subtract(even[1], odd[1]),
        subtract(even[2], odd[2]),
        add(even[2], odd[2]),
        add(even[3], odd[3]),
        subtract(even[3], odd[3]),
    )


@inlined
def _corners(one: Vector, eta: Vector, zeta: Vector, both: Vector) -> tuple[Vector, Vector, Vector, Vector]:
    """1/8 (one + eta .. + zeta .. + eta zeta ..) at (-, -), (+, -), (-, +), (+, +)."""
    near, far = subtract(one, zeta), add(one, zeta)
    near_eta, far_eta = subtract(eta, both), add(eta, both)
    return (
        scale(0.125, subtract(near, near_eta)),
        scale(0.125, add(near, near_eta)),
        scale(0.125, subtract(far, far_eta)),
        scale(0.125, add(far, far_eta)),
    )
