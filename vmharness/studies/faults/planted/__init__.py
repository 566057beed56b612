"""Faults to plant, one a file; the folder is the list. Each names a module, a text of it, and what is wrong instead."""
