"""The built-in solver: keywords -> model -> time loop -> states.

    model.py  loop.py  integrate.py  state.py    a deck as arrays; the method; its kernels; what moves
    force.py  constraint.py                      the two kinds of things that the loop knows
    energy.py  balance.py  probes/               what is watched and read off, outside the loop

Some folders are lists: each file or folder in one is a formulation with its keywords, and is found there.

    elements  materials  contacts  loads  constraints  walls  bodies  initial  damping  timestep

The others hold mechanics that the formulations of a list share.

    shell  hexahedron     elements: of shells, of solids
    plasticity            materials: yield and return
    contact               contacts: from the cards of a keyword to its force
    surface               contacts: faces, thickness and stiffness of the deck's surfaces
    penalty               contacts: search, force, friction, step
    rigid                 bodies: motion of rigid bodies, and their joints

What many of them read of the deck: parts.py, material.py, sets.py, curve.py, dof.py; shells.py, solids.py, beams.py.
What kernels are made of: compiled.py, threads.py, vector.py, turn.py, lanes.py, segment.py.
How their compiled forms are kept: cache.py, kept.py, meaning.py.
"""
