"""The commands of `vm`, one a file; the folder is the list."""
