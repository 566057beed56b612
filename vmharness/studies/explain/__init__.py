"""Causes of the error of each result, and readings of published columns."""
