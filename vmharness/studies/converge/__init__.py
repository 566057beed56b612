"""Observed order of accuracy, extrapolated value and its uncertainty."""
