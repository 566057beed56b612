"""Contact formulations, one a file; the folder is the list."""
