"""Constitutive laws, one a file; the folder is the list."""
