"""The rotation of an element in a finite step, from its chord velocity.

A step of finite rotation theta has the chord velocity v = w x x_{n-1/2} with |w| = 2 tan(theta/2) / dt: strain and
curvature increments are exactly zero on the mid-step geometry. But omega of the nodes is theta / dt. In the shear,
v_z,x and v_z,y are therefore scaled by atan(s)/s = 1 - s^2/3 + O(s^4), s = |w| dt/2.
"""

from vmharness.explicit.kernels.vector import Vector, inlined


@inlined
def chord_factor(v_x: Vector, v_y: Vector, dt: float) -> float:
    """atan(s)/s, to second order; `v_x`, `v_y`: gradients of the velocity in the element's frame."""
    spin_z = 0.5 * (v_x[1] - v_y[0])
    return 1 - dt * dt / 12 * (v_y[2] * v_y[2] + v_x[2] * v_x[2] + spin_z * spin_z)
