"""*SECTION: formulations and cross-sections of elements."""
