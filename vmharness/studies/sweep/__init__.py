"""Runs of a case over a region of the given data."""
