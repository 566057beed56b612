"""Beams and trusses: elements of two nodes with a section. `_parts.py` has what they share."""

from vmharness.explicit.elements.beam._parts import ELFORMS, beam_parts, lengths, volume

__all__ = ["ELFORMS", "beam_parts", "lengths", "volume"]
