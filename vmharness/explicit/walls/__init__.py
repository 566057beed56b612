"""*RIGIDWALL_PLANAR: nodes kept in front of a rigid plane, which stands or moves along its normal n with a mass M.

With the gap g_i of a node, its normal velocity u_i and that of the wall w, no node ends a step behind the wall, and
the wall only pushes. The impulses p_i of a step satisfy, all at once,

    g_i + dt (u_i' - w') >= 0        p_i >= 0        p_i [g_i + dt (u_i' - w')] = 0
    u_i' = u_i + p_i/m_i             w' = w - sum p_i/M              (M infinite for a wall that stands)

so that p_i = m_i max(0, w' - s_i), s_i = u_i + g_i/dt, and w' is the root of M (w - w') = sum p_i (impulse.py). A node
that would pass through the wall ends its step on it, and has the wall's velocity after the next step: a perfectly
plastic impact of that node. A body of many nodes rebounds by its own elasticity. A node on the wall that is pressed
against it has, in the same way, the acceleration A = dw/dt of the wall,

    r_i = m_i max(0, A - a_i . n)        M A = -sum r_i

and one that is pulled away has r_i = 0. Friction changes the tangential momentum q_i of the step by up to f p_i:

    FRIC = 0 none        0 < FRIC < 1 Coulomb, f = FRIC        FRIC = 1 no sliding

Momentum is conserved between wall and nodes to round-off. The energy "rigid wall" is the kinetic energy of a moving
wall, and the work that impacts and friction have dissipated.

Walls act one after another, in the deck's order. Where several meet at right angles without friction this is exact;
otherwise a node may end a step behind the earlier wall by a fraction of its path, which the next step corrects.

A wall acts on nodes that come from its front. A node that is behind it, by passing the edge of a finite wall or before
BIRTH, passes through. A node that a support or a prescribed motion rules along n is left out. The wall acts from BIRTH
to DEATH; OFFSET > 0 leaves out nodes that begin farther from it. Nodes of rigid bodies are left out.

Source: LS-DYNA keyword manual, the cards and the default treatment, by momentum and not by penalty (RWPNAL = 0);
J. J. Moreau, Unilateral contact and dry friction in finite freedom dynamics (1988), for the conditions.

    face.py     the plane and its edges               wall.py     the wall as a constraint
    impulse.py  one step of all nodes, as kernels     planar.py   walls and their nodes, from the deck
"""
