"""*BOUNDARY: supports and prescribed motion."""
