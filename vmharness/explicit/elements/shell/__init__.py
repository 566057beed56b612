"""What the shells share: the law at points through the thickness, its change, one step of many elements, the force.

    rows.py        how elements lie in the buffer of explicit/kernels/simd.py
    point.py       a material's law at one height of every element
    thickness.py   that follows the strain through it (ISTUPD)
    step.py        one step of many elements, from the stages of a kind
    kind.py        what a kind of shell has of its own: geometry, rates, forces, mass, length
    part.py        the shells of a part as a force; build.py: from the deck

The kinds are in elements/shell_belytschko_tsay and elements/shell_c0_triangle.
"""
