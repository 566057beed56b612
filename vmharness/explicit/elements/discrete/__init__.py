"""*ELEMENT_DISCRETE: springs and dampers between two nodes, or between a node and the ground.

    d_n  = d_{n-1} + dt ddot_{n-1/2}        ddot_{n-1/2} = (v_2 - v_1) . m        f = S law(d, ddot)

The force f, positive in tension, pulls node 1 along the axis e and node 2 against it. The axis is the direction of
*DEFINE_SD_ORIENTATION, fixed in space, with m = e; or it goes from node 1 to node 2, r = x_2 - x_1:

    e_n = r_n/|r_n|        m = (r_{n-1} + r_n)/(|r_{n-1}| + |r_n|)

With this m the increment dt ddot is |r_n| - |r_{n-1}|, the change of length without error however far the element
turns. A torsional element (DRO = 1) has angular velocities for v, a rotation for d and moments for f; the axis is
found in the same way. The elongation begins at OFFSET. Discrete elements have no mass, and a node without rotary
inertia does not turn.

Source: LS-DYNA keyword manual, the cards; the equations follow from the definitions of length and work.
"""

from vmharness.explicit.elements.discrete.build import build

__all__ = ["build"]
