"""What the solids of eight nodes share: geometry in patterns, the frame that turns, bulk viscosity, the stable step.

    pattern.py     the motion of the nodes as seven patterns
    gradient.py    volume, gradients, sides
    motion.py      first stage of a step: patterns, mean velocity gradient at mid-step, the element's frame
    strain.py      strain increments in that frame
    stress.py      a material's law at one point of every element
    viscosity.py   bulk viscosity and the stable step
    rows.py        how all this lies in the buffer of explicit/kernels/simd.py
    part.py        the solids of a part as a force; channel.py: what is read of their stress; build.py: from the deck

The formulations are in elements/hexa_one_point and elements/hexa_full.
"""
