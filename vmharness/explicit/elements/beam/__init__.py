"""Beams and trusses: elements of two nodes with a section."""
