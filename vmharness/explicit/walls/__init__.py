"""Rigid walls, one a file or folder; the folder is the list."""
