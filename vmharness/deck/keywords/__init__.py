"""The keywords of LS-DYNA as data, one family a file; the folder is the list.

A card says what the format is: fields, columns, defaults. What a solver can do with the values is said by the solver.
"""
