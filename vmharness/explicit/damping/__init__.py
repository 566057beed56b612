"""Damping, one kind a file; the folder is the list."""
