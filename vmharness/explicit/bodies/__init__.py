"""Bodies that take nodes over once all masses are known, one kind a file; the folder is the list."""
