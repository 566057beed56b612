"""*ELEMENT_DISCRETE: springs and dampers between two nodes, or between a node and the ground.

    d_n  = d_{n-1} + dt ddot_{n-1/2}        ddot_{n-1/2} = (v_2 - v_1) . m        f = S law(d, ddot)

The force f, positive in tension, pulls node 1 along the axis e and node 2 against it. With a vector a that the axis
lies along,

    e_n = a_n/|a_n|        m = (a_{n-1} + a_n)/(|a_{n-1}| + |a_n|)

where r = x_2 - x_1 and a is by *DEFINE_SD_ORIENTATION, with w its vector (IOP 0, 1) or that between its nodes (2, 3):

    none        a = r
    IOP 0, 2    a = w
    IOP 1, 3    a = r - (r . w) w / (w . w), the projection on the plane normal to w

With a = r the increment is dt ddot = |r_n| - |r_{n-1}|, the exact change of length however far the element rotates; for
IOP 1 it is the exact change of the length in the plane. An axis that is not along r exerts a moment, since its
two forces are not on one line. A torsional element (DRO = 1) has angular velocities for v, a rotation for d and moments
for f; the axis is found in the same way. The elongation begins at OFFSET.

With a clearance CL the spring acts in compression alone, from d = -CL on: the law gets min(d + CL, 0). An element whose
elongation exceeds FD (tension if positive, compression if negative) fails permanently.

Discrete elements have no mass, and a node without rotary inertia does not rotate.

Source: LS-DYNA keyword manual, the cards; the equations follow from the definitions of length and work.
"""

from vmharness.explicit.elements.discrete.build import build

NAME = "spring or damper"

__all__ = ["NAME", "build"]
