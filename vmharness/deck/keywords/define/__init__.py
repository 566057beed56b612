"""*DEFINE: curves and orientations."""
