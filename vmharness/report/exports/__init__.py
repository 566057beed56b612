"""Formats for machines, one a file: each renders all runs as one text; the folder is the list."""
