"""Rigid bodies: nodes whose motion is that of a centre and a rotation.

The centre of a body is a row of the state like that of a node, numbered by the body's number with a minus sign. It has
all the mass M of the body, and its nodes have none, so that body loads, forces on the body, damping and prescribed
translations act on it as they act on a node. Forces and moments on the nodes are summed at the centre,

    F = sum f_k        T = sum (x_k - c) x f_k + m_k

and the time loop moves the centre. Rotation is described by the angular momentum L in space and the orientation R, in
the leapfrog of the loop, with the implicit midpoint rule on the group of rotations:

    L_{n+1/2} = L_{n-1/2} + 1/2 (dt_{n-1} + dt_n) T_n
    omega = R_{n+1/2} I^-1 R_{n+1/2}^T L_{n+1/2},   R_{n+1/2} = exp(dt/2 omega) R_n,   R_{n+1} = exp(dt omega) R_n

Without torque L is constant to round-off. With torque about a fixed principal axis this is the leapfrog of a mass. The
order is 2. A step forward and a step back cancel, so that the energy oscillates with dt^2 and does not drift. Nodes are
set on c + R arm: their velocity over the step is the chord (x_{n+1} - x_n)/dt.

At t_n, L_n = L_{n-1/2} + dt/2 T_n and omega_n = R_n I^-1 R_n^T L_n. The kinetic energy is 1/2 M v_n^2 +
1/2 omega_n . L_n.

Rotations that are held (CMO of *MAT_RIGID) or driven (*BOUNDARY_PRESCRIBED_MOTION_RIGID) are given global components of
omega; the others follow by the mobility R I^-1 R^T that is left (mobility.py).

    body.py  inertia.py  element_mass.py                     the bodies of the deck: nodes, mass and inertia
    initial_velocity.py                                      their velocities at t = 0
    integrate.py  mobility.py  bodies.py                     the step of all bodies: kernels, arrays
    joints.py  joint_equations.py  joint_cards.py            joints between bodies
    constraints.py  check.py  mass_shares.py  build.py       bodies in the time loop and beside other parts of a model

Source: J. C. Simo, K. K. Wong, Unconditionally stable algorithms for rigid body dynamics that exactly preserve energy
and momentum, International Journal for Numerical Methods in Engineering 31 (1991) 19-52; P. Krysl, L. Endres, Explicit
Newmark/Verlet algorithm for time integration of the rotational dynamics of rigid bodies, ibid. 62 (2005) 2154-2177
(the implicit midpoint Lie algorithm, there LIEMID[I]).
"""
