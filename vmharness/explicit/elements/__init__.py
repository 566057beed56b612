"""Element formulations, one a file; the folder is the list."""
