"""Damping in proportion to mass and to stiffness."""
