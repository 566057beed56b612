"""Shells: what the formulations share.

    _parts.py         the shells of the deck, part by part, with thickness, area and volume
    _build.py         a part of the deck -> its force and its mass
    _shells.py        the shells of a part as a force
    _formulation.py   interface of a formulation: geometry, mass, strain, hourglass control, nodal force
    _step.py          one step of many elements, in the stages of a formulation
    _point.py         the law of the material at one height of every element
    _thickness.py     change of thickness (ISTUPD)
    _chord.py         finite rotation of an element in one step
    _rows.py          rows of the elements in the buffer of kernels/simd.py

The formulations are belytschko_tsay/ and c0_triangle/.
"""

from vmharness.explicit.elements.shell._parts import area, shell_parts, thickness, volume

__all__ = ["area", "shell_parts", "thickness", "volume"]
