"""Formats of the manual, one a file: each renders the page of a case, and the index; the folder is the list."""
