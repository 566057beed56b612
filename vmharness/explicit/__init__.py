"""The built-in solver: explicit dynamics by central differences, from a deck to states.

    build.py        a deck -> its model; the order of the passes, with reasons
    loop.py         the method: forces -> accelerations -> velocities -> positions
    state.py        positions, velocities, forces, masses: the arrays that the loop updates
    force.py        what the loop asks of a force: elements, contacts, loads
    constraint.py   what the loop asks of a constraint: supports, motions, damping, walls, rigid bodies
    energy.py       energies, and their ratio
    balance.py      energies that cannot be: what makes a run unfit to be judged
    watch.py        what is watched of a run: its balance, and the step that its contacts need
    drilling.py     nodes of shells that can spin about the normal
    threads.py      forces of all elements, by several threads if NCPU asks for them
    supported.py    what the solver supports of each keyword: SUPPORTS of the modules, joined
    references/     whether the deck defines what its cards refer to
    without_effect.py  keywords that change no result
    error.py        the error that ends a run

Rooms by theory:

    model        nodes, parts, sets, curves and rigid bodies of the deck as arrays
    kernels      compilation and its cache; vectors, rotations, elements side by side
    elements     beams, shells, solids, springs and dampers, masses        (drop-ins, by formulation)
    materials    constitutive laws for each state of stress                (drop-ins, by law)
    contact      penalty contact: search, force, friction; contact/kinds   (drop-ins, by kind)
    loads        body loads, nodal loads, pressure                         (drop-ins, by kind)
    probes       quantities of a running model                             (drop-ins, by kind)
    rigid        rigid bodies and their joints
    walls        planar rigid walls
    constraints  supports and prescribed motion of nodes
    initial      velocities at t = 0
    damping      mass damping and stiffness damping
    timestep     limits of the step, mass scaling, the step that contacts need

A drop-in is a file or folder that is found by being there: nothing else names it. What it must define is written in
the docstring of its folder and checked at import. Its file name has no effect.
"""
