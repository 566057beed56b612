"""The formulas over a region of the given data."""
