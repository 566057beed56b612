"""Figures of the page of a case."""
