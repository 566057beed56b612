"""Solids of eight nodes: what the formulations share.

    _parts.py       the solids of the deck, part by part, with volume and bulk viscosity
    _build.py       a part of the deck -> its force and its mass
    _solids.py      the solids of a part as a force; _channel.py: the components of stress that a probe shows
    _pattern.py     the motion of eight nodes as eight patterns
    _gradient.py    volume, gradients, faces
    _motion.py      first stages of a step: patterns, mean velocity gradient, rotating frame, mean strain
    _stress.py      the law of the material at one point of every element
    _viscosity.py   bulk viscosity and the stable step
    _rows.py        rows of the elements in the buffer of kernels/simd.py

The formulations are one_point/ and full/.
"""

from vmharness.explicit.elements.solid._gradient import measures
from vmharness.explicit.elements.solid._parts import ELFORMS, solid_parts, volume
from vmharness.explicit.elements.solid._solids import Hexahedra

__all__ = ["ELFORMS", "Hexahedra", "measures", "solid_parts", "volume"]
