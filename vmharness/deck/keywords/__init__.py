"""Keywords that carry data only: one keyword family a file; the folder is the list."""
